#pragma once

#include "solver/base/vec3.hpp"

namespace eerie::remnants {

/// A clump or group of clumps seen as a point.
struct PointMass {
  double mass = 0;  ///< kg
  Vec3 x, v;        ///< centre of mass, m and m/s
};

/// The common centre of mass of two.
PointMass together(const PointMass& one, const PointMass& other);

/// Two-body orbit of one point mass about another, SI.
struct Orbit {
  double mu = 0;  ///< G (m1 + m2)
  double distance = 0;
  double eccentricity = 0, semi_latus_rectum = 0;
  double specific_energy = 0;  ///< of the relative motion, J/kg; bound below 0
  double pericentre = 0;       ///< smallest distance
  bool approaching = false;
  double time_to_pericentre = 0;  ///< until the next passage; infinity when it never comes

  bool bound() const { return specific_energy < 0; }
};

/// Kepler's equation by the eccentric (hyperbolic) anomaly, e.g. Murray & Dermott (1999), ch. 2.
/// The two must not be at the same place.
Orbit relative_orbit(const PointMass& one, const PointMass& other);

/// Time until the next inward passage through `distance`, s: 0 when already inside, infinity when
/// the orbit does not come so close any more.
double time_to_reach(const Orbit& orbit, double distance);

}  // namespace eerie::remnants
