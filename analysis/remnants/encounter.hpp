#pragma once

#include "analysis/remnants/orbit.hpp"
#include "analysis/remnants/remnants.hpp"

namespace eerie::remnants {

/// A remnant as a point.
PointMass point(const Remnant& remnant);

/// Two bodies by the orbit of one about the other, SI.
struct Encounter {
  Orbit orbit;
  double contact = 0;  ///< distance of their centres at which they touch

  bool comes_back() const { return orbit.bound() || orbit.approaching; }
  bool will_touch() const { return comes_back() && orbit.pericentre < contact; }
  /// Until they touch; infinity where they will not.
  double time_s() const;
};

/// Of two remnants: contact at the sum of half their longest axes.
Encounter encounter(const Remnant& one, const Remnant& other);
/// Of a remnant and a fragment without extent.
Encounter encounter(const Remnant& one, const PointMass& fragment);

}  // namespace eerie::remnants
