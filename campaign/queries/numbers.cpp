#include "campaign/queries/numbers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

#include "campaign/sweeps/scene_field.hpp"
#include "solver/base/error.hpp"

namespace eerie::queries {
namespace {

/// The finite number at the beginning of a text, and how many characters it takes; 0 without one.
std::pair<double, std::size_t> leading_number(const std::string& text) {
  double value = 0;
  const char* begin = text.data() + (text.starts_with('+') && !text.starts_with("+-") ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return {0, 0};
  return {sweeps::rounded(value), static_cast<std::size_t>(end - text.data())};
}

double parse_number(const std::string& text, const std::string& whole, const std::string& option) {
  const std::optional<double> value = finite_number(text);
  if (value) return *value;
  throw InputError(
      fmt::format("{} {}: must be LO:HI or one number, all finite; for example {} 18:22", option,
                  whole, option));
}

}  // namespace

std::optional<double> finite_number(const std::string& text) {
  const auto [value, used] = leading_number(text);
  return used > 0 && used == text.size() ? std::optional(value) : std::nullopt;
}

double parse_duration(const std::string& text, const std::string& option) {
  struct Unit {
    const char* name;
    double seconds;
  };
  constexpr Unit units[] = {{"s", 1}, {"min", 60}, {"h", 3600}, {"d", 86400}};
  const auto [value, used] = leading_number(text);
  if (used > 0 && value > 0 && value < 1e9)
    for (const Unit& unit : units)
      if (text.substr(used) == unit.name) return value * unit.seconds;
  throw InputError(
      fmt::format("{} {}: must be a positive time with its unit, s, min, h or d; for example {} 2h",
                  option, text, option));
}

std::vector<double> parse_times(const std::string& text, const std::string& option,
                                std::size_t most) {
  std::vector<double> times;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    word.erase(0, word.find_first_not_of(' '));
    const std::optional<double> time = finite_number(word);
    if (!time || *time < 0)
      throw InputError(fmt::format(
          "{} {}: must be times in s with commas between them; for example {} 0,5000,10000", option,
          text, option));
    times.push_back(*time);
  }
  if (times.size() > most)
    throw InputError(
        fmt::format("{}: {} times are too many, {} are the most", option, times.size(), most));
  return times;
}

db::Range parse_range(const std::string& text, const std::string& option) {
  const std::size_t colon = text.find(':');
  const double lo = parse_number(text.substr(0, colon), text, option);
  const double hi =
      colon == std::string::npos ? lo : parse_number(text.substr(colon + 1), text, option);
  if (hi < lo)
    throw InputError(fmt::format("{} {}: LO is greater than HI; swap them", option, text));
  return {lo, hi};
}

}  // namespace eerie::queries
