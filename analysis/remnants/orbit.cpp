#include "analysis/remnants/orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/base/constants.hpp"

namespace eerie::remnants {

namespace {

/// Energies below this part of the potential make a parabola: the anomalies lose their digits.
constexpr double parabolic = 1e-9;

/// Time since the last (< 0: until the next) pericentre on the way through distance r, where
/// r . v = r_v; on an ellipse, a parabola or a hyperbola.
double time_since_pericentre(const Orbit& orbit, double r, double r_v) {
  const double mu = orbit.mu, energy = orbit.specific_energy;
  if (std::abs(energy) < parabolic * mu / r) {  // Barker's equation
    const double s = r_v / std::sqrt(mu);
    return (orbit.semi_latus_rectum / 2 * s + cubed(s) / 6) / std::sqrt(mu);
  }
  const double a = mu / (2 * std::abs(energy)), rate = std::sqrt(mu / cubed(a));
  const double e_sin = r_v / std::sqrt(mu * a);  // e sin E, or e sinh H
  if (energy < 0) return (std::atan2(e_sin, 1 - r / a) - e_sin) / rate;
  return (e_sin - std::asinh(e_sin / orbit.eccentricity)) / rate;
}

double period(const Orbit& orbit) {
  const double a = -orbit.mu / (2 * orbit.specific_energy);
  return 2 * pi * std::sqrt(cubed(a) / orbit.mu);
}

}  // namespace

PointMass together(const PointMass& one, const PointMass& other) {
  const double mass = one.mass + other.mass;
  return {mass, (one.mass * one.x + other.mass * other.x) / mass,
          (one.mass * one.v + other.mass * other.v) / mass};
}

Orbit relative_orbit(const PointMass& one, const PointMass& other) {
  const Vec3 r = other.x - one.x, v = other.v - one.v;
  const Vec3 l = cross(r, v);
  const double r_v = dot(r, v);
  Orbit orbit;
  orbit.mu = newton_G * (one.mass + other.mass);
  orbit.distance = norm(r);
  orbit.eccentricity = norm(cross(v, l) / orbit.mu - r / orbit.distance);
  orbit.semi_latus_rectum = norm2(l) / orbit.mu;
  orbit.specific_energy = norm2(v) / 2 - orbit.mu / orbit.distance;
  orbit.pericentre = orbit.semi_latus_rectum / (1 + orbit.eccentricity);
  orbit.approaching = r_v < 0;
  const double since = time_since_pericentre(orbit, orbit.distance, r_v);
  if (since <= 0)
    orbit.time_to_pericentre = -since;
  else
    orbit.time_to_pericentre =
        orbit.bound() ? period(orbit) - since : std::numeric_limits<double>::infinity();
  return orbit;
}

double time_to_reach(const Orbit& orbit, double distance) {
  if (distance >= orbit.distance) return 0;
  if (distance < orbit.pericentre) return std::numeric_limits<double>::infinity();
  // r . v on the way in, from energy and angular momentum: (r . v)^2 = r^2 v^2 - l^2.
  const double v2 = 2 * (orbit.specific_energy + orbit.mu / distance);
  const double r_v2 = distance * distance * v2 - orbit.mu * orbit.semi_latus_rectum;
  return orbit.time_to_pericentre +
         time_since_pericentre(orbit, distance, -std::sqrt(std::max(r_v2, 0.0)));
}

}  // namespace eerie::remnants
