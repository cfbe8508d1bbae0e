#include "analysis/settled.hpp"

#include <fmt/format.h>

#include <cmath>

#include "analysis/orbit.hpp"

namespace eerie {

namespace {

PointMass point(const Remnant& r) { return {r.mass, r.x, r.v}; }

struct Pair {
  Orbit orbit;
  double contact = 0;  ///< sum of the half longest axes, m
  bool one_group = false;

  bool will_touch() const { return pericentre_inside() && (orbit.bound() || orbit.approaching); }
  bool pericentre_inside() const { return orbit.pericentre < contact; }
};

std::string describe(const Remnant& one, const Remnant& other, const Pair& pair) {
  std::string text = fmt::format("remnants {} and {} ({:.3f} and {:.3f} of the mass) are ",
                                 one.rank, other.rank, one.mass_over_total, other.mass_over_total);
  text += pair.orbit.bound() ? "bound to each other"
          : pair.one_group   ? "in one bound group"
                             : "closing in on each other";
  text += fmt::format(", {:.0f} m apart", pair.orbit.distance);
  if (pair.will_touch())
    return text + fmt::format(
                      " and will meet in about {:.1f} h (pericentre {:.0f} m, contact at "
                      "{:.0f} m)",
                      time_to_reach(pair.orbit, pair.contact) / 3600, pair.orbit.pericentre,
                      pair.contact);
  return text + fmt::format("; their pericentre of {:.0f} m is outside of contact at {:.0f} m",
                            pair.orbit.pericentre, pair.contact);
}

Pair pair_of(const Remnant& one, const Remnant& other) {
  return {relative_orbit(point(one), point(other)), (one.shape.a + other.shape.a) / 2,
          one.bound_group == other.bound_group};
}

}  // namespace

bool will_meet(std::span<const Remnant> remnants) {
  for (std::size_t i = 0; i < remnants.size(); ++i)
    for (std::size_t j = i + 1; j < remnants.size(); ++j)
      if (pair_of(remnants[i], remnants[j]).will_touch()) return true;
  return false;
}

std::string unsettled_reason(std::span<const Remnant> remnants) {
  std::string reason;
  int others = 0;
  for (std::size_t i = 0; i < remnants.size(); ++i)
    for (std::size_t j = i + 1; j < remnants.size(); ++j) {
      const Remnant &one = remnants[i], &other = remnants[j];
      const Pair pair = pair_of(one, other);
      if (!pair.one_group && !pair.will_touch()) continue;
      if (reason.empty())
        reason = describe(one, other, pair);
      else
        ++others;
    }
  if (others > 0) reason += fmt::format("; {} more pair{}", others, others == 1 ? "" : "s");
  return reason;
}

}  // namespace eerie
