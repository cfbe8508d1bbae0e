#include "analysis/light_curve/shadow.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace eerie::light_curve {

namespace {

/// Columns are finer than rows: a span of a row costs the same however long it is.
constexpr double columns_per_row = 4;

/// One bit for each pixel.
class Raster {
 public:
  Raster(std::size_t columns, std::size_t rows)
      : words_((columns + 63) / 64), bits_(words_ * rows, 0) {}

  /// Blackens the columns from `first` to `last`, both included.
  void blacken(std::size_t row, std::size_t first, std::size_t last) {
    std::uint64_t* line = bits_.data() + row * words_;
    const std::uint64_t from = ~std::uint64_t{0} << (first % 64);
    const std::uint64_t to = ~std::uint64_t{0} >> (63 - last % 64);
    if (first / 64 == last / 64) {
      line[first / 64] |= from & to;
      return;
    }
    line[first / 64] |= from;
    for (std::size_t k = first / 64 + 1; k < last / 64; ++k) line[k] = ~std::uint64_t{0};
    line[last / 64] |= to;
  }

  double black() const {
    long sum = 0;
    for (const std::uint64_t word : bits_) sum += std::popcount(word);
    return static_cast<double>(sum);
  }

 private:
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

struct Plane {
  double u, v;
};

/// Positions in the plane across `along`, in units of `unit`.
std::vector<Plane> projected(std::span<const Vec3> x, const Vec3& along, double unit) {
  const Vec3 n = along / norm(along);
  const Vec3 aside = std::abs(n.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  Vec3 u = cross(aside, n);
  u = u / (norm(u) * unit);
  const Vec3 v = cross(n, u);
  std::vector<Plane> points;
  points.reserve(x.size());
  for (const Vec3& p : x) points.push_back({dot(u, p), dot(v, p)});
  return points;
}

}  // namespace

double shadow_area(std::span<const Vec3> x, double radius, const Vec3& along,
                   double pixels_per_radius) {
  if (x.empty()) return 0;
  const double pixel = radius / pixels_per_radius, r = pixels_per_radius;
  const std::vector<Plane> points = projected(x, along, pixel);
  const auto [left, right] = std::ranges::minmax(points, {}, &Plane::u);
  const auto [lowest, highest] = std::ranges::minmax(points, {}, &Plane::v);
  // The centre of row or column i lies at i. Some room leaves every disc inside; with the odd part
  // of it, discs in rows and columns of a lattice do not all end on the centres of pixels.
  constexpr double room = 1.382;
  const double u0 = left.u - r - room, v0 = lowest.v - r - room;
  const auto pixels = [&](double extent) { return extent + 2 * (r + room) + 1; };
  Raster raster(static_cast<std::size_t>(columns_per_row * pixels(right.u - left.u)),
                static_cast<std::size_t>(pixels(highest.v - lowest.v)));
  for (const Plane& point : points) {
    const double u = point.u - u0, v = point.v - v0;
    for (double row = std::ceil(v - r); row <= v + r; ++row) {
      const double half = std::sqrt(std::max(r * r - (row - v) * (row - v), 0.0));
      const double first = std::ceil(columns_per_row * (u - half));
      const double last = std::floor(columns_per_row * (u + half));
      if (first <= last)
        raster.blacken(static_cast<std::size_t>(row), static_cast<std::size_t>(first),
                       static_cast<std::size_t>(last));
    }
  }
  return raster.black() * pixel * pixel / columns_per_row;
}

}  // namespace eerie::light_curve
