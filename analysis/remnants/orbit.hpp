#pragma once

#include "solver/base/vec3.hpp"

namespace eerie::remnants {

/// A clump or a group of clumps as a point mass.
struct PointMass {
  double mass = 0;  ///< kg
  Vec3 x, v;        ///< centre of mass, m and m/s
};

/// The sum of two point masses, at their common centre of mass.
PointMass together(const PointMass& one, const PointMass& other);

/// The two-body orbit of one point mass about another, in SI.
struct Orbit {
  double mu = 0;  ///< G (m1 + m2)
  double distance = 0;
  double eccentricity = 0, semi_latus_rectum = 0;
  double specific_energy = 0;  ///< of the relative motion, J/kg; negative where bound
  double pericentre = 0;       ///< the smallest distance, m
  bool approaching = false;
  double time_to_pericentre = 0;  ///< time until the next passage; infinity where none comes

  bool bound() const { return specific_energy < 0; }
};

/// Solves Kepler's equation by the eccentric or hyperbolic anomaly (Murray & Dermott 1999, ch. 2).
/// The two must not be at the same place.
Orbit relative_orbit(const PointMass& one, const PointMass& other);

/// The time until the next inward passage through `distance`, s. It is 0 inside that distance, and
/// infinity where the orbit does not come so close any more.
double time_to_reach(const Orbit& orbit, double distance);

}  // namespace eerie::remnants
