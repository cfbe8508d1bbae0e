#pragma once

#include <cmath>

#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"

namespace eerie {

/// Two spheres at the moment of contact, in SI. The angle (rad) lies between their relative
/// velocity and the line of their centres.
struct Contact {
  double distance = 0, speed = 0, angle = 0;
  double mu = 0;  ///< G times the sum of the masses, m^3/s^2
};

/// The contact of `target` with an impactor of `q` times its mass.
inline Contact contact_of(const Sphere& target, double impactor_radius, double q, double speed,
                          double angle) {
  return {target.radius + impactor_radius, speed, angle, newton_G * mass(target) * (1 + q)};
}

/// The square of the radial speed, (m/s)^2, when the two centres were `distance` apart. It follows
/// from the energy and the angular momentum of their Kepler orbit. A negative value means that they
/// never were that far apart.
inline double radial_speed2(const Contact& c, double distance) {
  const double momentum = c.distance * c.speed * std::sin(c.angle);
  return c.speed * c.speed + 2 * c.mu * (1 / distance - 1 / c.distance) -
         momentum * momentum / (distance * distance);
}

/// The least speed at contact, m/s, with which bodies can arrive from `distance`, at the angle of
/// `c`.
inline double least_contact_speed(const Contact& c, double distance) {
  const double part = c.distance * std::sin(c.angle) / distance;
  return std::sqrt(2 * c.mu * (1 / c.distance - 1 / distance) / (1 - part * part));
}

}  // namespace eerie
