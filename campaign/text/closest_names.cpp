#include "campaign/text/closest_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <string_view>

#include "campaign/text/synonyms.hpp"

namespace eerie::text {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

/// Letters and digits alone, small: what people remember of v_imp_cm_per_s is vimp.
std::string bare(const std::string& name) {
  std::string letters;
  for (const char letter : name) {
    const auto c = static_cast<unsigned char>(letter);
    if (std::isalnum(c) != 0) letters += static_cast<char>(std::tolower(c));
  }
  return letters;
}

std::string last_part(const std::string& name) {
  const std::string last = name.substr(name.rfind('.') + 1);
  return last.substr(std::min(last.find_first_not_of('-'), last.size()));
}

/// How far `given` is from a name: people use another word, misspell whole paths, forget all but
/// the last part, or shorten that.
std::size_t distance(const std::string& given, const std::string& name) {
  const std::string last = last_part(name), core = bare(last_part(given));
  if (is_synonym(core, last)) return 0;
  if (core.size() > 2 && bare(last).find(core) != std::string::npos) return 1;
  return std::min({edit_distance(given, name), edit_distance(given, last),
                   edit_distance(last_part(given), last)});
}

std::vector<std::string> by_distance(const std::string& given, std::vector<std::string> names) {
  constexpr std::size_t shown = 3;
  std::stable_sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return distance(given, a) < distance(given, b);
  });
  names.erase(std::unique(names.begin(), names.end()), names.end());
  names.resize(std::min(names.size(), shown));
  return names;
}

}  // namespace

std::string closest_names(const std::string& given, std::vector<std::string> names) {
  return fmt::format("{}", fmt::join(by_distance(given, std::move(names)), ", "));
}

std::vector<std::string> likely_names(const std::string& given, std::vector<std::string> names) {
  names = by_distance(given, std::move(names));
  // A slip in each three letters; but of a single letter all would be one slip away.
  const std::size_t letters = last_part(given).size();
  const std::size_t most = std::max<std::size_t>(1, letters / 3);
  std::erase_if(names, [&](const std::string& name) {
    const std::size_t far = distance(given, name);
    return far > most || far >= letters;
  });
  // What is meant goes alone: names that only look like it would confuse.
  if (!names.empty() && distance(given, names.front()) == 0)
    std::erase_if(names, [&](const std::string& name) { return distance(given, name) > 0; });
  return names;
}

}  // namespace eerie::text
