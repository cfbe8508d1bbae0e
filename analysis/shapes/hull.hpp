#pragma once

#include <array>
#include <span>

#include "solver/base/vec3.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::shapes {

/// The rectangular box of least volume that holds a body, in any orientation: the extent of its
/// convex hull. Where the ellipsoid of inertia says how mass is spread, the box says how far
/// the body reaches: of two touching spheres the ellipsoid has b/a = 1/sqrt(6) = 0.41, the box
/// 0.5.
struct HullBox {
  double a = 0, b = 0, c = 0;  ///< lengths of its edges, m; a >= b >= c
  std::array<Vec3, 3> axes{};  ///< their directions, unit vectors, right-handed
  Vec3 centre;                 ///< m

  double b_over_a() const { return a > 0 ? b / a : 0; }
  double c_over_a() const { return a > 0 ? c / a : 0; }
};

/// Box around spheres of the given radius (m; 0: points) at the positions x (m). It holds every
/// sphere exactly. Its orientation is the best of twelve local minima of the volume, found to 1e-5
/// rad from the most promising of 400 orientations, the principal axes among them; nothing proves
/// that there is no better one. All lengths are 0 without points. O(N), with a constant of
/// thousands.
HullBox box_of_hull(std::span<const Vec3> x, double radius = 0);

/// Radius of the sphere that holds a particle's share of the material at rest, m: how far matter
/// reaches beyond the particles' centres, how large they are drawn, what shadow they cast.
double particle_radius(const io::Snapshot& snapshot);

}  // namespace eerie::shapes
