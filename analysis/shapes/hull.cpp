#include "analysis/shapes/hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/shapes/shape.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/random.hpp"
#include "solver/scene/two_materials.hpp"

namespace eerie::shapes {

namespace {

using Axes = std::array<Vec3, 3>;

constexpr std::size_t directions = 2000;  ///< that outermost points are looked for in
constexpr std::size_t starts = 400;       ///< orientations, of which the best are refined
constexpr std::size_t refined = 12;
constexpr double coarse_angle = 0.15, fine_angle = 1e-5;  ///< rad

/// Points evenly spread over half of the unit sphere (a Fibonacci lattice).
std::vector<Vec3> half_sphere(std::size_t count) {
  const double golden = pi * (3 - std::sqrt(5.0));
  std::vector<Vec3> found;
  for (std::size_t k = 0; k < count; ++k) {
    const double z = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    const double r = std::sqrt(1 - z * z), phase = golden * static_cast<double>(k);
    found.push_back({r * std::cos(phase), r * std::sin(phase), z});
  }
  return found;
}

/// Points of the convex hull: the outermost ones along directions about 0.06 rad apart. Those left
/// out stand less than some 1/2000 of the extent out of the hull of those found.
std::vector<Vec3> outermost(std::span<const Vec3> x) {
  if (x.size() <= directions / 2) return {x.begin(), x.end()};
  std::vector<std::size_t> chosen;
  for (const Vec3& n : half_sphere(directions)) {
    std::size_t low = 0, high = 0;
    double lowest = dot(n, x[0]), highest = lowest;
    for (std::size_t i = 1; i < x.size(); ++i) {
      const double along = dot(n, x[i]);
      if (along < lowest) lowest = along, low = i;
      if (along > highest) highest = along, high = i;
    }
    chosen.insert(chosen.end(), {low, high});
  }
  std::ranges::sort(chosen);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  std::vector<Vec3> points;
  points.reserve(chosen.size());
  for (const std::size_t i : chosen) points.push_back(x[i]);
  return points;
}

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  double length() const { return high - low; }
};

Extent extent(std::span<const Vec3> x, const Vec3& along) {
  Extent e;
  for (const Vec3& p : x) {
    const double at = dot(along, p);
    e.low = std::min(e.low, at), e.high = std::max(e.high, at);
  }
  return e;
}

/// Turns a unit vector about another (Rodrigues).
Vec3 turned(const Vec3& v, const Vec3& about, double angle) {
  return std::cos(angle) * v + std::sin(angle) * cross(about, v) +
         (1 - std::cos(angle)) * dot(about, v) * about;
}

Axes turned(const Axes& axes, const Vec3& about, double angle) {
  const Vec3 first = turned(axes[0], about, angle);
  Vec3 second = turned(axes[1], about, angle);
  second -= dot(first, second) * first;  // rounding must not add up
  second = second / norm(second);
  return {first / norm(first), second, cross(first / norm(first), second)};
}

struct Candidate {
  double volume = 0;
  Axes axes{};
};

Candidate candidate(std::span<const Vec3> hull, double radius, const Axes& axes) {
  double volume = 1;
  for (const Vec3& axis : axes) volume *= extent(hull, axis).length() + 2 * radius;
  return {volume, axes};
}

/// Smaller turns as long as they help, about the box's own axes and all their diagonals: at its
/// minimum the volume has kinks, along which no single axis leads down.
Candidate refine(std::span<const Vec3> hull, double radius, Candidate best) {
  for (double angle = coarse_angle; angle > fine_angle;) {
    Candidate next = best;
    for (int k = 0; k < 27; ++k) {
      const int i = k % 3 - 1, j = k / 3 % 3 - 1, l = k / 9 - 1;
      if (i == 0 && j == 0 && l == 0) continue;
      const Vec3 about = 1.0 * i * best.axes[0] + 1.0 * j * best.axes[1] + 1.0 * l * best.axes[2];
      const Candidate tried =
          candidate(hull, radius, turned(best.axes, about / norm(about), angle));
      if (tried.volume < next.volume) next = tried;
    }
    if (next.volume < best.volume)
      best = next;
    else
      angle /= 2;
  }
  return best;
}

/// Orientations all over, the same ones each time; those of the principal axes first.
std::vector<Axes> orientations(std::span<const Vec3> x) {
  std::vector<Axes> found = {ellipsoid_of_inertia(x).axes};
  Random random(1, 0);
  while (found.size() < starts) {
    const Vec3 first = random.direction();
    const Vec3 second = cross(first, random.direction());
    if (norm(second) > 0.1)
      found.push_back({first, second / norm(second), cross(first, second / norm(second))});
  }
  return found;
}

HullBox measured(std::span<const Vec3> x, double radius, const Axes& axes) {
  std::array<Extent, 3> e;
  std::array<std::size_t, 3> order = {0, 1, 2};
  for (std::size_t k = 0; k < 3; ++k) e[k] = extent(x, axes[k]);
  std::ranges::sort(order, std::greater(), [&](std::size_t k) { return e[k].length(); });
  HullBox box;
  box.a = e[order[0]].length() + 2 * radius;
  box.b = e[order[1]].length() + 2 * radius;
  box.c = e[order[2]].length() + 2 * radius;
  box.axes = {axes[order[0]], axes[order[1]], cross(axes[order[0]], axes[order[1]])};
  for (std::size_t k = 0; k < 3; ++k) box.centre += (e[k].low + e[k].high) / 2 * axes[k];
  return box;
}

}  // namespace

HullBox box_of_hull(std::span<const Vec3> x, double radius) {
  if (x.empty()) return {};
  const std::vector<Vec3> hull = outermost(x);
  std::vector<Candidate> candidates;
  for (const Axes& axes : orientations(x)) candidates.push_back(candidate(hull, radius, axes));
  // The principal axes are always among those that are refined.
  std::ranges::sort(candidates.begin() + 1, candidates.end(), {}, &Candidate::volume);
  Candidate best = candidates.front();
  for (std::size_t k = 0; k < refined; ++k) {
    const Candidate found = refine(hull, radius, candidates[k]);
    if (found.volume < best.volume) best = found;
  }
  return measured(x, radius, best.axes);
}

double particle_radius(const io::Snapshot& snapshot) {
  const double volume = snapshot.state.mass / lowest_density(snapshot.scene);
  return std::cbrt(3 * volume / (4 * pi));
}

}  // namespace eerie::shapes
