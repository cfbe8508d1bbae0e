#include "solver/scene/tide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"

namespace eerie {

bool has_primary(const Scene& scene) { return scene.environment.primary.mass_kg > 0; }

bool may_fly(const Scene& scene) { return scene.numerics.rigid_flight && !has_primary(scene); }

Scene without_primary(Scene scene) {
  scene.environment.primary = {};
  return scene;
}

void require_primary(const Scene& scene, const std::string& where) {
  if (!has_primary(scene)) return;
  const Scene::Primary& p = scene.environment.primary;
  if (!scene.environment.self_gravity)
    throw InputError(where +
                     ".environment.self_gravity = false: environment.primary needs bodies that "
                     "attract; set it to true, or primary.mass_kg to 0");
  if (p.radius_m == 0)
    throw InputError(where +
                     ".environment.primary.radius_m = 0: a point would throw out particles that "
                     "come near; give the radius of the primary, 360 for Dinkinesh");
  const double least = p.radius_m + contact_distance(scene) * scene.impact.separation;
  if (p.distance_m < least)
    throw InputError(fmt::format(
        "{}.environment.primary.distance_m = {:g}: the bodies would start on the primary; give "
        "{:.4g} or more",
        where, p.distance_m, least));
}

Tide::Tide(const Scene::Primary& p)
    : pull_(newton_G * p.mass_kg),
      distance_(p.distance_m),
      radius_(p.radius_m),
      azimuth_(radians(p.azimuth_deg)),
      rate_(p.mass_kg == 0 ? 0.0
                           : std::sqrt(pull_ / distance_) / distance_ * (p.retrograde ? -1 : 1)) {}

Vec3 Tide::place(double time) const {
  const double angle = azimuth_ + rate_ * time;
  return {distance_ * std::cos(angle), distance_ * std::sin(angle), 0};
}

Vec3 Tide::acceleration(const Vec3& x, const Vec3& primary) const {
  if (pull_ == 0) return {};
  const Vec3 to = primary - x;
  // Inside a homogeneous ball the pull falls in proportion to the distance from its centre.
  const double away = std::max(norm(to), radius_);
  return pull_ / (away * away * away) * to - pull_ / (distance_ * distance_ * distance_) * primary;
}

double hill_radius(const Scene& s) {
  if (!has_primary(s)) return std::numeric_limits<double>::infinity();
  const Scene::Primary& p = s.environment.primary;
  return p.distance_m * std::cbrt(target_mass(s) * (1 + s.impact.q) / (3 * p.mass_kg));
}

}  // namespace eerie
