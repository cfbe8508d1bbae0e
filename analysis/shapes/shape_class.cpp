#include "analysis/shapes/shape_class.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace eerie::shapes {
namespace {

constexpr double bins_per_smoothing = 4;
constexpr double reach = 4;  ///< of the Gaussian, in standard deviations

/// Number of particles in bins along the axis, with empty room for the Gaussian at both ends.
std::vector<double> histogram(std::span<const Vec3> x, const Vec3& axis, double bin) {
  double low = dot(x[0], axis), high = low;
  for (const Vec3& p : x) low = std::min(low, dot(p, axis)), high = std::max(high, dot(p, axis));
  const double room = reach * bins_per_smoothing;
  std::vector<double> counts(static_cast<std::size_t>((high - low) / bin + 2 * room) + 1);
  for (const Vec3& p : x) counts[static_cast<std::size_t>((dot(p, axis) - low) / bin + room)] += 1;
  return counts;
}

std::vector<double> smoothed(const std::vector<double>& counts) {
  constexpr int width = static_cast<int>(reach * bins_per_smoothing);
  const int n = static_cast<int>(counts.size());
  std::vector<double> sums(counts.size());
  for (int i = 0; i < n; ++i)
    for (int j = std::max(0, i - width); j < std::min(n, i + width + 1); ++j) {
      const double distance = (i - j) / bins_per_smoothing;
      sums[static_cast<std::size_t>(i)] +=
          counts[static_cast<std::size_t>(j)] * std::exp(-distance * distance / 2);
    }
  return sums;
}

}  // namespace

std::string_view name(ShapeClass shape) {
  return shape_class_names[static_cast<std::size_t>(shape)].name;
}

double neck(std::span<const Vec3> x, const Vec3& axis, double smoothing) {
  if (x.empty()) return 1;
  const std::vector<double> counts = histogram(x, axis, smoothing / bins_per_smoothing);
  const std::vector<double> section = smoothed(counts);
  std::vector<double> widest_beyond(section);
  for (std::size_t k = section.size() - 1; k-- > 0;)
    widest_beyond[k] = std::max(widest_beyond[k], widest_beyond[k + 1]);
  const double n = static_cast<double>(x.size());
  double before = 0, widest_before = 0, thinnest = 1;
  for (std::size_t k = 0; k < section.size(); ++k) {
    before += counts[k];
    widest_before = std::max(widest_before, section[k]);
    if (std::min(before, n - before) >= lobe_min_mass * n)
      thinnest = std::min(thinnest, section[k] / std::min(widest_before, widest_beyond[k]));
  }
  return thinnest;
}

ShapeClass classify_shape(const Shape& shape, double neck) {
  if (neck < bilobed_max_neck) return ShapeClass::bilobed;
  if (shape.b_over_a() < zingg_ratio) return ShapeClass::elongated;
  if (shape.c < zingg_ratio * shape.b) return ShapeClass::flat;
  return ShapeClass::spherical;
}

}  // namespace eerie::shapes
