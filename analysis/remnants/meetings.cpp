#include "analysis/remnants/meetings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/remnants/encounter.hpp"

namespace eerie::remnants {

namespace {

bool in_one_group(const Remnant& one, const Remnant& other) {
  return one.bound_group == other.bound_group;
}

/// Remnants come by falling mass.
std::span<const Remnant> heavier_than(double fragment, std::span<const Remnant> remnants) {
  const auto light = std::ranges::find_if(
      remnants, [&](const Remnant& r) { return r.mass_over_total <= fragment; });
  return {remnants.begin(), light};
}

std::string describe(const Remnant& one, const Remnant& other, const Encounter& pair) {
  std::string text = fmt::format("remnants {} and {} ({:.3f} and {:.3f} of the mass) are ",
                                 one.rank, other.rank, one.mass_over_total, other.mass_over_total);
  text += pair.orbit.bound()         ? "bound to each other"
          : in_one_group(one, other) ? "in one bound group"
                                     : "closing in on each other";
  text += fmt::format(", {:.0f} m apart", pair.orbit.distance);
  if (pair.will_touch())
    return text + fmt::format(
                      " and will meet in about {:.1f} h (pericentre {:.0f} m, contact at "
                      "{:.0f} m)",
                      pair.time_s() / 3600, pair.orbit.pericentre, pair.contact);
  if (!pair.comes_back()) return text + "; by themselves the two would part";
  return text + fmt::format("; their pericentre of {:.0f} m is outside of contact at {:.0f} m",
                            pair.orbit.pericentre, pair.contact);
}

}  // namespace

bool will_meet(std::span<const Remnant> remnants, double fragment) {
  const std::span<const Remnant> large = heavier_than(fragment, remnants);
  for (std::size_t i = 0; i < large.size(); ++i)
    for (std::size_t j = i + 1; j < large.size(); ++j)
      if (encounter(large[i], large[j]).will_touch()) return true;
  return false;
}

std::string unsettled_reason(std::span<const Remnant> remnants, double fragment) {
  std::string reason;
  int others = 0;
  const std::span<const Remnant> large = heavier_than(fragment, remnants);
  for (std::size_t i = 0; i < large.size(); ++i)
    for (std::size_t j = i + 1; j < large.size(); ++j) {
      const Remnant &one = large[i], &other = large[j];
      const Encounter pair = encounter(one, other);
      if (!in_one_group(one, other) && !pair.will_touch()) continue;
      if (reason.empty())
        reason = describe(one, other, pair);
      else
        ++others;
    }
  if (others > 0) reason += fmt::format("; {} more pair{}", others, others == 1 ? "" : "s");
  return reason;
}

std::string unsettled_reason_in_tide(std::span<const Remnant> remnants, double fragment) {
  const std::size_t large = heavier_than(fragment, remnants).size();
  if (large < 2) return "";
  return fmt::format("{} remnants go about the primary, and their orbits are not predicted", large);
}

}  // namespace eerie::remnants
