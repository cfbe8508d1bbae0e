#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "solver/base/vec3.hpp"

namespace eerie::shapes {

/// The uniform ellipsoid that has the inertia of a set of equal point masses:
/// a = sqrt(10 (I1 + I2 - I3)/M) and so on, I1 >= I2 >= I3 (Sugiura et al. 2019).
struct Shape {
  double a = 0, b = 0, c = 0;  ///< full lengths of the principal axes, m; a >= b >= c
  std::array<Vec3, 3> axes{};  ///< their directions, unit vectors, right-handed
  std::string degenerate;      ///< why some length is 0; empty for a body with a volume

  double b_over_a() const { return a > 0 ? b / a : 0; }
  double c_over_a() const { return a > 0 ? c / a : 0; }
};

/// The shape of points at the positions x, m, about any origin. Points have no extent, as in the
/// paper, so N points on a lattice of spacing s lack s^2/12 in every second moment.
Shape ellipsoid_of_inertia(std::span<const Vec3> x);

/// The angular velocity of equal point masses about their centre of mass, from L = I omega, rad/s.
/// Nothing where the inertia tensor has no inverse (points on one line).
std::optional<Vec3> angular_velocity(std::span<const Vec3> x, std::span<const Vec3> v);

}  // namespace eerie::shapes
