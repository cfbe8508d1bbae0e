#include "solver/scene/body_shape.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/base/bodies/ellipsoid.hpp"
#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/scene/two_materials.hpp"

namespace eerie {

Vec3 spin_axis(const Scene::Spin& spin) {
  const double tilt = radians(spin.tilt_deg), node = radians(spin.node_deg);
  return {std::sin(tilt) * std::cos(node), std::sin(tilt) * std::sin(node), std::cos(tilt)};
}

double spin_rate(const Scene::Spin& spin) {
  return spin.period_h == 0 ? 0 : 2 * pi / (3600 * spin.period_h);
}

BodyShape::BodyShape(const Scene::Shape& shape, const Scene::Spin& spin)
    : is_sphere_(shape.b_over_a == 1 && shape.c_over_a == 1) {
  if (is_sphere_) return;
  const double a = 1 / std::cbrt(shape.b_over_a * shape.c_over_a);
  semi_axes_ = {a, a * shape.b_over_a, a * shape.c_over_a};
  const double tilt = radians(spin.tilt_deg), node = radians(spin.node_deg),
               turn = radians(shape.turn_deg);
  // The shortest axis, the direction in which it is tilted, and the one across.
  const Vec3 pole = spin_axis(spin);
  const Vec3 along = {std::cos(tilt) * std::cos(node), std::cos(tilt) * std::sin(node),
                      -std::sin(tilt)};
  const Vec3 across = cross(pole, along);
  directions_ = {std::cos(turn) * along + std::sin(turn) * across,
                 std::cos(turn) * across - std::sin(turn) * along, pole};
}

Vec3 BodyShape::on_sphere(const Vec3& x) const {
  if (is_sphere_) return x;
  Vec3 there;
  for (int k = 0; k < 3; ++k) {
    const Vec3& axis = directions_[static_cast<std::size_t>(k)];
    there += (dot(axis, x) / semi_axes_[k]) * axis;
  }
  return there;
}

BodyShape target_shape(const Scene& s) { return {s.target.shape, s.target.spin}; }
BodyShape impactor_shape(const Scene& s) { return {s.impactor.shape, s.impactor.spin}; }

namespace {

double friction_of(const Scene::Material& m) {
  return m.rheology == "fluid" ? 0 : friction_coefficient(m);
}

void require_round_one_stands(const Scene::Material& m, const Scene::Spin& spin,
                              const std::string& field) {
  if (spin.period_h == 0) return;
  const double fastest = fastest_spin(m.rho0_kg_per_m3, friction_of(m));
  const double shortest_h = fastest > 0 ? 2 * pi / fastest / 3600 : 0;
  if (fastest > 0 && spin.period_h >= shortest_h) return;
  throw InputError(
      fastest > 0
          ? fmt::format("{}.spin.period_h = {:g}: at a friction angle of {:g} deg a sphere without "
                        "cohesion stands no shorter period than {:.4g} h; give {:.3g} or more",
                        field, spin.period_h, m.drucker_prager.phi_d_deg, shortest_h,
                        1.05 * shortest_h)
          : fmt::format("{}.spin.period_h = {:g}: a sphere without friction stands no rotation; "
                        "set it to 0, or material.rheology to \"drucker-prager\"",
                        field, spin.period_h));
}

void require_long_one_stands(const Scene::Material& m, const BodyShape& shape,
                             const Scene::Spin& spin, const std::string& field) {
  const double needed = needed_friction(shape.semi_axes(), m.rho0_kg_per_m3, spin_rate(spin)),
               friction = friction_of(m);
  if (needed <= friction) return;
  const Vec3& a = shape.semi_axes();
  const std::string why =
      std::isfinite(needed)
          ? fmt::format("needs a friction angle of {:.3g} deg", degrees(std::atan(needed)))
          : "has no weight at its ends";
  throw InputError(fmt::format(
      "{0}.shape with b_over_a = {1:g} and c_over_a = {2:g}: such an ellipsoid without cohesion "
      "{3} "
      "({0}.spin.period_h = {4:g}), the material has {5:g} deg; give axes nearer to each other, "
      "another period or more friction",
      field, a.y / a.x, a.z / a.x, why, spin.period_h, degrees(std::atan(friction))));
}

}  // namespace

void require_standing(const Scene& scene, const std::string& where) {
  const auto check = [&](const Scene::Material& m, const BodyShape& shape, const Scene::Spin& spin,
                         const char* body) {
    const bool is_loose = m.rheology == "fluid" ||
                          (m.rheology == "drucker-prager" && m.drucker_prager.cohesion_Pa == 0);
    if (!is_loose) return;
    if (shape.is_sphere())
      require_round_one_stands(m, spin, where + body);
    else
      require_long_one_stands(m, shape, spin, where + body);
  };
  // A remnant has shown that it stands.
  if (scene.target.remnant.file.empty())
    check(scene.material, target_shape(scene), scene.target.spin, ".target");
  check(impactor_material(scene), impactor_shape(scene), scene.impactor.spin, ".impactor");
}

}  // namespace eerie
