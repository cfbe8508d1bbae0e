#pragma once

#include <array>
#include <span>

#include "solver/base/vec3.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::shapes {

/// The rectangular box of least volume that contains a body, in any orientation. It measures the
/// extent of the body, while the ellipsoid of inertia measures how its mass is spread. For two
/// touching spheres the ellipsoid has b/a = 1/sqrt(6) = 0.41 and the box 0.5.
struct HullBox {
  double a = 0, b = 0, c = 0;  ///< lengths of its edges, m; a >= b >= c
  std::array<Vec3, 3> axes{};  ///< their directions, unit vectors, right-handed
  Vec3 centre;                 ///< m

  double b_over_a() const { return a > 0 ? b / a : 0; }
  double c_over_a() const { return a > 0 ? c / a : 0; }
};

/// Makes the box around spheres of the given radius (m; 0 means points) at the positions x (m). It
/// contains every sphere exactly. Its orientation is the best of twelve local minima of the volume.
/// The search starts from the best of 400 orientations, the principal axes among them, and resolves
/// 1e-5 rad. A better orientation may exist. All lengths are 0 without points. The cost is O(N),
/// with a constant of thousands.
HullBox box_of_hull(std::span<const Vec3> x, double radius = 0);

/// The radius of the sphere that contains a particle's share of the material at rest, m. It says
/// how far matter extends beyond the centres of particles, how large they are drawn, and what
/// shadow they cast.
double particle_radius(const io::Snapshot& snapshot);

}  // namespace eerie::shapes
