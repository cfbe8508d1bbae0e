#pragma once

#include "solver/scene/scene.hpp"

namespace eerie::proof {

/// Ratios of the axes of a body of liquid that keeps one side to a heavy primary far away; a
/// points to the primary and c is the axis of the revolution. `tide` is G M/d^3 over pi G rho.
/// Equal pressure at the ends of the axes asks for
///   (2 A_a - 3 tide) a^2 = 2 A_b b^2 = (2 A_c + tide) c^2
/// with Chandrasekhar's (1969, chapter 8) coefficients of attraction; he finds no figure above
/// 0.0901.
struct RocheEllipsoid {
  bool exists = false;
  double b_over_a = 0, c_over_a = 0;
};
RocheEllipsoid roche_ellipsoid(double tide);

/// A liquid body of `particles` in such a tide, and brought to rest in the turning frame for
/// `damped_s`, then left alone for `alone_s`.
struct LiquidInTide {
  double b_over_a, c_over_a;
  double a_over_radius;  ///< half of the longest axis over the radius of the sphere of its volume
  double off_deg;        ///< between the longest axis and the line to the primary
};
LiquidInTide liquid_in_tide(double tide, int particles, double damped_s, double alone_s);

}  // namespace eerie::proof
