#pragma once

#include <algorithm>
#include <cmath>

#include "solver/base/constants.hpp"

namespace eerie {

/// A sphere of uniform density.
struct Sphere {
  double radius = 0;   ///< m
  double density = 0;  ///< kg/m^3
};

inline double mass(const Sphere& s) { return s.density * sphere_volume(s.radius); }

/// The pressure at the centre of a sphere under its own weight, (2/3) pi G rho^2 R^2, Pa (Sugiura
/// et al. 2019, Eq. 3).
inline double central_pressure(const Sphere& s) {
  return 2 * pi / 3 * newton_G * s.density * s.density * s.radius * s.radius;
}

/// The escape speed from the surface of a sphere, R sqrt((8/3) pi G rho), m/s.
inline double escape_speed(const Sphere& s) {
  return s.radius * std::sqrt(8 * pi / 3 * newton_G * s.density);
}

/// The fastest spin at which a sphere of density rho (kg/m^3) without cohesion stands, rad/s. Its
/// stresses, averaged over the volume, are (rho R^2/5) (omega^2 - 4 pi G rho/3) across the axis and
/// -(rho R^2/5) 4 pi G rho/3 along it; friction bears sqrt(J2) <= mu p (Holsapple 2001). At the
/// equator matter must have weight.
inline double fastest_spin(double rho, double mu) {
  const double held = 2 * mu / 3, by_friction = held / (1 / std::sqrt(3.0) + held);
  return std::sqrt(2 * pi * newton_G * rho * std::min(by_friction, 2.0 / 3));
}

/// The mutual escape speed at contact, sqrt(2 G (M_t + M_i) / (R_t + R_i)), m/s. The impactor has
/// `q` times the mass of `target`.
inline double mutual_escape_speed(const Sphere& target, double impactor_radius, double q) {
  return std::sqrt(2 * newton_G * mass(target) * (1 + q) / (target.radius + impactor_radius));
}
/// The same for an impactor of the density of `target`.
inline double mutual_escape_speed(const Sphere& target, double q) {
  return mutual_escape_speed(target, target.radius * std::cbrt(q), q);
}

}  // namespace eerie
