#include "solver/initial/orbit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"

namespace eerie::initial {

RelativeOrbit orbit_at_contact(double contact, double v_imp, double theta_imp) {
  // Line of centres turned by theta_imp from +x, towards +y: then x cross v has +z.
  return {{contact * std::cos(theta_imp), contact * std::sin(theta_imp), 0}, {-v_imp, 0, 0}};
}

RelativeOrbit orbit_before_contact(const RelativeOrbit& at_contact, double mu, double distance) {
  const Vec3 &r = at_contact.position, &v = at_contact.velocity;
  const double energy = 0.5 * norm2(v) - mu / norm(r);
  const double speed2 = 2 * (energy + mu / distance);
  const Vec3 momentum = cross(r, v);
  const double h2 = norm2(momentum), radial2 = speed2 - h2 / (distance * distance);
  if (radial2 < 0)
    throw InputError(fmt::format(
        "scene.impact.v_imp_cm_per_s = {:g}: on this orbit the bodies were never {:.4g} m apart; "
        "raise v_imp_cm_per_s or lower impact.separation",
        100 * norm(v), distance));

  // Laplace-Runge-Lenz vector: points to pericentre, its length is the eccentricity.
  const Vec3 e = cross(v, momentum) / mu - r / norm(r);
  const double eccentricity = norm(e);
  const double p = h2 / mu;  // semi-latus rectum
  const double cosine = std::clamp((p / distance - 1) / eccentricity, -1.0, 1.0);
  const double sine = -std::sqrt(1 - cosine * cosine);  // before pericentre: negative anomaly
  const Vec3 to_pericentre = e / eccentricity;
  // In the orbital plane, 90 deg ahead of pericentre; a head-on orbit has no plane and no need.
  const Vec3 ahead = h2 > 0 ? cross(momentum / std::sqrt(h2), to_pericentre) : Vec3{};
  const Vec3 outward = cosine * to_pericentre + sine * ahead;
  const Vec3 tangent = h2 > 0 ? cross(momentum / std::sqrt(h2), outward) : Vec3{};
  return {distance * outward, -std::sqrt(radial2) * outward + (std::sqrt(h2) / distance) * tangent};
}

}  // namespace eerie::initial
