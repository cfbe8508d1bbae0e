#pragma once

#include <array>

#include "solver/base/vec3.hpp"
#include "solver/scene/scene.hpp"

namespace eerie {

/// A sphere or an ellipsoid about the origin. Its shortest axis is that of its spin; where it does
/// not turn, tilt and node of the spin still say where that axis points.
class BodyShape {
 public:
  /// A sphere.
  BodyShape() = default;
  BodyShape(const Scene::Shape& shape, const Scene::Spin& spin);

  bool is_sphere() const { return is_sphere_; }
  /// Semi-axes in units of the radius of the sphere of the same volume, the longest first.
  const Vec3& semi_axes() const { return semi_axes_; }
  /// Unit vectors along them.
  const std::array<Vec3, 3>& directions() const { return directions_; }
  /// The place in the sphere of the same volume that answers to the place `x` in the body. For a
  /// sphere this is `x` to the bit.
  Vec3 on_sphere(const Vec3& x) const;

 private:
  bool is_sphere_ = true;
  Vec3 semi_axes_ = {1, 1, 1};
  std::array<Vec3, 3> directions_ = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
};

/// The unit vector along the axis of a spin, also of a body that does not turn.
Vec3 spin_axis(const Scene::Spin& spin);
/// The rate of a spin, rad/s; 0 of a body that does not turn.
double spin_rate(const Scene::Spin& spin);

BodyShape target_shape(const Scene& scene);
BodyShape impactor_shape(const Scene& scene);

/// Throws InputError where loose rubble would flow before the impact: in a shape that gravity
/// pulls round, or in a rotation that pulls it apart. `where` names the scene.
void require_standing(const Scene& scene, const std::string& where);

}  // namespace eerie
