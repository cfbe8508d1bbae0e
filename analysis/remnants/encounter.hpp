#pragma once

#include "analysis/remnants/orbit.hpp"
#include "analysis/remnants/remnants.hpp"

namespace eerie::remnants {

/// A remnant as a point mass.
PointMass point(const Remnant& remnant);

/// The encounter of two bodies on the orbit of one about the other, in SI.
struct Encounter {
  Orbit orbit;
  double contact = 0;  ///< the distance of the centres at contact

  bool comes_back() const { return orbit.bound() || orbit.approaching; }
  bool will_touch() const { return comes_back() && orbit.pericentre < contact; }
  /// The time until they touch; infinity where they will not.
  double time_s() const;
};

/// The encounter of two remnants. They touch at the sum of their longest semi-axes.
Encounter encounter(const Remnant& one, const Remnant& other);
/// The encounter of a remnant with a fragment without extent.
Encounter encounter(const Remnant& one, const PointMass& fragment);

}  // namespace eerie::remnants
