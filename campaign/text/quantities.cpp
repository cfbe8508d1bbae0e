#include "campaign/text/quantities.hpp"

#include <fmt/format.h>

#include <array>

namespace eerie::text {

std::string duration(double seconds) {
  if (seconds < 60) return fmt::format("{:.0f} s", seconds);
  if (seconds < 3600)
    return fmt::format("{} min {} s", static_cast<long>(seconds) / 60,
                       static_cast<long>(seconds) % 60);
  if (seconds < 48 * 3600.0) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.1f} days", seconds / 86400);
}

std::string magnitude(double number) {
  constexpr std::array<const char*, 5> units = {"", " k", " M", " G", " T"};
  std::size_t unit = 0;
  while (number >= 999.5 && unit + 1 < units.size()) number /= 1000, ++unit;
  return fmt::format("{:.3g}{}", number, units[unit]);
}

std::string count_of(std::size_t number, const std::string& thing) {
  return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

}  // namespace eerie::text
