#include "campaign/text/closest_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <string_view>

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

/// How far `given` is from a name: people misspell whole paths, forget all but the last part, or
/// shorten that.
std::size_t distance(const std::string& given, const std::string& name) {
  const std::string last = name.substr(name.rfind('.') + 1);
  const std::string core = bare(given);
  if (core.size() > 2 && bare(last).find(core) != std::string::npos) return 1;
  return std::min(edit_distance(given, name), edit_distance(given, last));
}

}  // namespace

std::string closest_names(const std::string& given, std::vector<std::string> names) {
  constexpr std::size_t shown = 3;
  std::stable_sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return distance(given, a) < distance(given, b);
  });
  names.erase(std::unique(names.begin(), names.end()), names.end());
  names.resize(std::min(names.size(), shown));
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace eerie::text
