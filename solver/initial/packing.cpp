#include "solver/initial/packing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/base/error.hpp"
#include "solver/base/packs.hpp"
#include "solver/base/tensor.hpp"

namespace eerie::initial {

namespace {

/// A uniformly distributed rotation: a random axis frame turned by a random angle (Rodrigues).
Mat3 random_rotation(Random& random) {
  const Vec3 z = random.direction();
  const Vec3 other = std::abs(z.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  Vec3 x = cross(other, z);
  x *= 1 / norm(x);
  const Vec3 y = cross(z, x);
  const double angle = random.uniform(0, 2 * pi), c = std::cos(angle), s = std::sin(angle);
  const Vec3 u = c * x + s * y, w = c * y - s * x;
  return {{{u.x, w.x, z.x}, {u.y, w.y, z.y}, {u.z, w.z, z.z}}};
}

/// Points of unit number density in a periodic cube: one at random in each unit cell, then
/// pushed apart until even.
class PeriodicGlass {
 public:
  PeriodicGlass(int side, Random& random, const std::function<bool()>& stop)
      : side_(side), cells_(std::max(3, static_cast<int>(side / reach))) {
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j)
        for (int k = 0; k < side; ++k)
          points_.push_back({i + random.uniform(), j + random.uniform(), k + random.uniform()});
    for (int n = 0; n < sweeps; ++n) {
      if (stop && stop()) throw PackingStopped();
      relax();
    }
  }
  const std::vector<Vec3>& points() const { return points_; }

 private:
  static constexpr double reach = 1.6;  ///< of the repulsion, in mean spacings
  static constexpr double mobility = 0.15;
  static constexpr int sweeps = 150;

  /// One sweep of repulsion. Cells are at least `reach` wide, so 27 of them hold all partners;
  /// partners from across the border are shifted by a whole period.
  void relax() {
    const int c = cells_;
    const auto cells = static_cast<std::size_t>(c);
    std::vector<std::vector<Vec3>> content(cells * cells * cells);
    const auto place = [&](int i, int j, int k) {
      return (static_cast<std::size_t>(i) * cells + static_cast<std::size_t>(j)) * cells +
             static_cast<std::size_t>(k);
    };
    for (const Vec3& p : points_) content[place(cell(p.x), cell(p.y), cell(p.z))].push_back(p);
    points_.clear();
    for (int i = 0; i < c; ++i)
      for (int j = 0; j < c; ++j)
        for (int k = 0; k < c; ++k) {
          partners_.clear();
          for (int a = i - 1; a <= i + 1; ++a)
            for (int b = j - 1; b <= j + 1; ++b)
              for (int d = k - 1; d <= k + 1; ++d) {
                const Vec3 shift{period(a), period(b), period(d)};
                for (const Vec3& p : content[place(wrap(a), wrap(b), wrap(d))])
                  partners_.add(p + shift);
              }
          for (const Vec3& p : content[place(i, j, k)]) points_.push_back(moved(p));
        }
  }

  Vec3 moved(const Vec3& p) const {
    DoublePack push[3] = {};
    for (const auto& [x, y, z] : partners_.packs) {
      const DoublePack dx = p.x - x, dy = p.y - y, dz = p.z - z;
      const DoublePack r2 = dx * dx + dy * dy + dz * dz + 1e-30;  // itself pushes by 0, not 0/0
      const DoublePack per_r = inverse_sqrt(r2), s = positive_part(1 - (1 / reach) * r2 * per_r),
                       strength = s * s * per_r;
      push[0] += strength * dx, push[1] += strength * dy, push[2] += strength * dz;
    }
    double sum[16];
    lane_sums(push, sum);
    Vec3 q = p + mobility * Vec3{sum[0], sum[1], sum[2]};
    for (int k = 0; k < 3; ++k) q[k] -= side_ * std::floor(q[k] / side_);
    return q;
  }

  int cell(double coordinate) const {
    return std::min(static_cast<int>(coordinate / side_ * cells_), cells_ - 1);
  }
  int wrap(int i) const { return (i + cells_) % cells_; }
  double period(int i) const { return i < 0 ? -side_ : i >= cells_ ? side_ : 0; }

  /// Points by coordinates; those that fill up the last pack are far away.
  struct Partners {
    std::vector<std::array<DoublePack, 3>> packs;
    std::size_t count = 0;

    void clear() { packs.clear(), count = 0; }
    void add(const Vec3& p) {
      const auto lane = static_cast<int>(count++ % lanes<double>);
      if (lane == 0) packs.push_back({splat(far), splat(far), splat(far)});
      for (int k = 0; k < 3; ++k) packs.back()[static_cast<std::size_t>(k)][lane] = p[k];
    }
    static constexpr double far = 1e9;
  };

  double side_;
  int cells_;
  std::vector<Vec3> points_;
  Partners partners_;
};

/// Of the points of a periodic pattern (period `side`, unit density), the `n` innermost of a body
/// about `centre`, relative to it; level2(d) is the square of a distance in which its surface is a
/// sphere, and `longest` its longest semi-axis over that one's radius.
template <class Level2>
std::vector<Vec3> innermost(const std::vector<Vec3>& pattern, double side, const Vec3& centre,
                            std::size_t n, double longest, Level2&& level2) {
  const double radius = std::cbrt(3 * static_cast<double>(n) / (4 * pi)) + 2;
  const int copies = static_cast<int>(std::ceil(radius * longest / side)) + 1;
  std::vector<Vec3> found;
  for (int i = -copies; i <= copies; ++i)
    for (int j = -copies; j <= copies; ++j)
      for (int k = -copies; k <= copies; ++k)
        for (const Vec3& p : pattern) {
          const Vec3 d = p + Vec3{i * side, j * side, k * side} - centre;
          if (level2(d) < radius * radius) found.push_back(d);
        }
  // stable_sort: points at equal distance stay in pattern order, so the choice is reproducible.
  std::stable_sort(found.begin(), found.end(),
                   [&](const Vec3& a, const Vec3& b) { return level2(a) < level2(b); });
  found.resize(n);
  return found;
}

}  // namespace

std::vector<Vec3> packed_sphere(const std::string& packing, std::size_t n, double radius,
                                Random& random, const std::function<bool()>& stop) {
  return packed_body({}, packing, n, radius, random, stop);
}

std::vector<Vec3> packed_body(const BodyShape& shape, const std::string& packing, std::size_t n,
                              double radius, Random& random, const std::function<bool()>& stop) {
  std::vector<Vec3> pattern;
  double side = 0;
  if (packing == "glass") {
    // A cube that holds the sphere, but at most 20 spacings wide: larger bodies tile it.
    const int cells =
        std::clamp(static_cast<int>(std::ceil(std::cbrt(2.6 * static_cast<double>(n)))), 8, 20);
    pattern = PeriodicGlass(cells, random, stop).points();
    side = cells;
  } else if (packing == "lattice") {
    side = std::cbrt(4.0);  // face-centred cubic: four points in a cube
    pattern = {
        {0, 0, 0}, {0, side / 2, side / 2}, {side / 2, 0, side / 2}, {side / 2, side / 2, 0}};
  } else {
    throw InputError("scene.numerics.packing: unknown name \"" + packing + "\"");
  }
  const Vec3 centre{random.uniform(0, side), random.uniform(0, side), random.uniform(0, side)};
  const Mat3 turn = random_rotation(random);
  std::vector<Vec3> points =
      innermost(pattern, side, centre, n, shape.semi_axes().x, [&](const Vec3& d) {
        return shape.is_sphere() ? norm2(d) : norm2(shape.on_sphere(turn * d));
      });
  const double spacing = radius * std::cbrt(4 * pi / (3 * static_cast<double>(n)));
  Vec3 mean;
  for (Vec3& p : points) mean += (p = spacing * (turn * p));
  mean *= 1 / static_cast<double>(n);
  for (Vec3& p : points) p -= mean;
  return points;
}

}  // namespace eerie::initial
