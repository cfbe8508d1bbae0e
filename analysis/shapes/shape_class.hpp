#pragma once

#include <array>
#include <span>
#include <string_view>

#include "analysis/shapes/shape.hpp"
#include "solver/base/vec3.hpp"

namespace eerie::shapes {

/// Classes of shape. A bilobed body has two lobes with a neck between them, whatever its axes.
/// Otherwise it is elongated where b/a < 2/3, flat where b/a >= 2/3 and c/b < 2/3, and spherical in
/// all other cases. Zingg (1935) chose two thirds.
enum class ShapeClass { spherical, flat, elongated, bilobed };

struct ShapeClassName {
  ShapeClass shape;
  std::string_view name;
};
inline constexpr std::array<ShapeClassName, 4> shape_class_names = {{
    {ShapeClass::spherical, "spherical"},
    {ShapeClass::flat, "flat"},
    {ShapeClass::elongated, "elongated"},
    {ShapeClass::bilobed, "bilobed"},
}};
std::string_view name(ShapeClass shape);

inline constexpr double zingg_ratio = 2.0 / 3;
/// A neck thinner than this makes a body bilobed: the cross-section between two equal spheres
/// that overlap with their centres one radius apart is 3/4 of a lobe's.
inline constexpr double bilobed_max_neck = 0.75;
/// The part beyond a neck is a lobe where it has at least this fraction of the mass.
inline constexpr double lobe_min_mass = 0.1;

/// The cross-section at the thinnest place between two lobes along `axis` (a unit vector), over
/// that of the thinner lobe; 1 where there is no neck. The cross-section is the number of particles
/// per length, smoothed by a Gaussian of standard deviation `smoothing` (m, > 0), so it misses
/// necks much shorter than that. x are the positions of equal masses, m.
double neck(std::span<const Vec3> x, const Vec3& axis, double smoothing);

ShapeClass classify_shape(const Shape& shape, double neck);

}  // namespace eerie::shapes
