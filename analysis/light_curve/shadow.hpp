#pragma once

#include <span>

#include "solver/base/vec3.hpp"

namespace eerie::light_curve {

/// How finely shadows are cut: rows of pixels in the radius of a particle. The area of one disc is
/// then true to half a per cent, that of the shadow of a body, where only the outline counts,
/// better.
inline constexpr double shadow_pixels_per_radius = 12;

/// Area of the shadow that equal spheres throw along a direction, m^2: that of the union of their
/// discs. Positions and radius in m; `along` need not be a unit vector. Discs are laid over
/// pixels four times as high as wide; a pixel counts when its centre is in a disc. O(N) for any one
/// body.
double shadow_area(std::span<const Vec3> x, double radius, const Vec3& along,
                   double pixels_per_radius = shadow_pixels_per_radius);

}  // namespace eerie::light_curve
