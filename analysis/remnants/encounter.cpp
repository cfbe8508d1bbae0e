#include "analysis/remnants/encounter.hpp"

#include <limits>

namespace eerie::remnants {

PointMass point(const Remnant& remnant) { return {remnant.mass, remnant.x, remnant.v}; }

double Encounter::time_s() const {
  return will_touch() ? time_to_reach(orbit, contact) : std::numeric_limits<double>::infinity();
}

Encounter encounter(const Remnant& one, const Remnant& other) {
  return {relative_orbit(point(one), point(other)), (one.shape.a + other.shape.a) / 2};
}

Encounter encounter(const Remnant& one, const PointMass& fragment) {
  return {relative_orbit(point(one), fragment), one.shape.a / 2};
}

}  // namespace eerie::remnants
