#pragma once

#include <span>

#include "solver/base/vec3.hpp"

namespace eerie::light_curve {

/// The resolution of shadows: rows of pixels per radius of a particle. The area of one disc is then
/// correct to half a per cent. That of the shadow of a body is better, since only its outline
/// contributes to the error.
inline constexpr double shadow_pixels_per_radius = 12;

/// The area of the shadow of equal spheres along a direction, m^2, that is, of the union of their
/// discs. Positions and radius are in m; `along` need not be a unit vector. Pixels are four times
/// as high as wide, and a pixel counts where its centre is in a disc. The cost is O(N).
double shadow_area(std::span<const Vec3> x, double radius, const Vec3& along,
                   double pixels_per_radius = shadow_pixels_per_radius);

}  // namespace eerie::light_curve
