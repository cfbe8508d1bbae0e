#pragma once

#include "solver/base/tensor.hpp"

namespace eerie {

/// A velocity or an acceleration as a rigid body has it: mean + spin x (x - centre).
struct RigidField {
  Vec3 centre, mean, spin;
  Vec3 at(const Vec3& x) const { return mean + cross(spin, x - centre); }
};

/// Sums over places and vectors there, which find the rigid field that is nearest to them in the
/// mean square. The centre is the mean of all places.
struct RigidSums {
  Vec3 vectors, moment;  ///< sum of v, of r x v
  SymTensor inertia;     ///< sum of r^2 1 - r r

  /// Adds v at r from the centre.
  void add(const Vec3& r, const Vec3& v) {
    vectors += v, moment += cross(r, v);
    const double r2 = norm2(r);
    inertia += {r2 - r.x * r.x, r2 - r.y * r.y, r2 - r.z * r.z, -r.x * r.y, -r.x * r.z, -r.y * r.z};
  }
  RigidSums& operator+=(const RigidSums& other) {
    vectors += other.vectors, moment += other.moment, inertia += other.inertia;
    return *this;
  }
  /// Places on a line have no spin about it, and get none at all.
  RigidField field(const Vec3& centre, double count) const {
    constexpr double rounding = 1e-14;
    const double det = determinant(inertia), size = trace(inertia);
    return {
        centre, vectors / count,
        det > rounding * size * size * size ? to_matrix(inverse(inertia, det)) * moment : Vec3{}};
  }
};

}  // namespace eerie
