#include "analysis/orbit.hpp"

#include <cmath>
#include <limits>

#include "solver/base/constants.hpp"

namespace eerie {

namespace {

/// Energies below this part of the potential make a parabola: the anomalies lose their digits.
constexpr double parabolic = 1e-9;

/// Time since the last (< 0: until the next) pericentre of an ellipse, a parabola, a hyperbola.
/// r_v = r . v; mu = G (m1 + m2).
double time_since_pericentre(double mu, double r, double r_v, double energy, double p, double e) {
  if (std::abs(energy) < parabolic * mu / r) {  // Barker's equation
    const double s = r_v / std::sqrt(mu);
    return (p / 2 * s + cubed(s) / 6) / std::sqrt(mu);
  }
  const double a = mu / (2 * std::abs(energy)), rate = std::sqrt(mu / cubed(a));
  const double e_sin = r_v / std::sqrt(mu * a);  // e sin E, or e sinh H
  if (energy < 0) return (std::atan2(e_sin, 1 - r / a) - e_sin) / rate;
  return (e_sin - std::asinh(e_sin / e)) / rate;
}

}  // namespace

PointMass together(const PointMass& one, const PointMass& other) {
  const double mass = one.mass + other.mass;
  return {mass, (one.mass * one.x + other.mass * other.x) / mass,
          (one.mass * one.v + other.mass * other.v) / mass};
}

Orbit relative_orbit(const PointMass& one, const PointMass& other) {
  const double mu = newton_G * (one.mass + other.mass);
  const Vec3 r = other.x - one.x, v = other.v - one.v;
  const Vec3 l = cross(r, v);
  const double r_v = dot(r, v), p = norm2(l) / mu;
  Orbit orbit;
  orbit.distance = norm(r);
  orbit.specific_energy = norm2(v) / 2 - mu / orbit.distance;
  const double e = norm(cross(v, l) / mu - r / orbit.distance);  // eccentricity
  orbit.pericentre = p / (1 + e);
  orbit.approaching = r_v < 0;
  const double since = time_since_pericentre(mu, orbit.distance, r_v, orbit.specific_energy, p, e);
  orbit.time_to_pericentre = -since;
  if (since > 0) {
    const double a = -mu / (2 * orbit.specific_energy);
    orbit.time_to_pericentre = orbit.bound() ? 2 * pi * std::sqrt(cubed(a) / mu) - since
                                             : std::numeric_limits<double>::infinity();
  }
  return orbit;
}

}  // namespace eerie
