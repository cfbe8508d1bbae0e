#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "solver/base/random.hpp"
#include "solver/base/tensor.hpp"
#include "solver/initial/packing.hpp"
#include "solver/tree/kd_tree.hpp"

namespace eerie::test {

/// Ids 0..n-1.
inline std::vector<std::uint32_t> ids(std::size_t n) {
  std::vector<std::uint32_t> id(n);
  std::iota(id.begin(), id.end(), 0u);
  return id;
}

/// The same points in memory order, as tree and lists want them.
inline std::vector<Vec3> in_kd_order(const std::vector<Vec3>& x) {
  std::vector<Vec3> sorted;
  for (const std::uint32_t i : tree::kd_order(x, ids(x.size()))) sorted.push_back(x[i]);
  return sorted;
}

/// A disordered ball of `n` points, mean spacing 1, in memory order.
inline std::vector<Vec3> glass_ball(std::size_t n, std::uint64_t seed = 1) {
  Random random(seed, n);
  return in_kd_order(
      initial::packed_sphere("glass", n, std::cbrt(3 * static_cast<double>(n) / (4 * pi)), random));
}

inline tree::KdTree fitted_tree(const std::vector<Vec3>& x) {
  tree::KdTree tree(x.size());
  tree.fit(x);
  return tree;
}

inline Mat3 random_matrix(Random& random) {
  Mat3 m;
  for (int k = 0; k < 9; ++k) m[k / 3][k % 3] = random.uniform(-1, 1);
  return m;
}

inline SymTensor random_tensor(Random& random) {
  const auto next = [&] { return random.uniform(-1, 1); };
  return {next(), next(), next(), next(), next(), next()};
}

/// Without its trace: a deviatoric stress.
inline SymTensor random_deviator(Random& random) {
  SymTensor s = random_tensor(random);
  const double third = trace(s) / 3;
  s.xx -= third, s.yy -= third, s.zz -= third;
  return s;
}

inline double largest_entry(const Mat3& m) {
  double largest = 0;
  for (int k = 0; k < 9; ++k) largest = std::max(largest, std::abs(m[k / 3][k % 3]));
  return largest;
}

inline Mat3 difference(const Mat3& a, const Mat3& b) {
  Mat3 d;
  for (int k = 0; k < 9; ++k) d[k / 3][k % 3] = a[k / 3][k % 3] - b[k / 3][k % 3];
  return d;
}

/// Right-handed rotation about `axis` (unit) by `angle` (Rodrigues).
inline Mat3 rotation(const Vec3& axis, double angle) {
  Mat3 m;
  const double c = std::cos(angle), s = std::sin(angle);
  for (int column = 0; column < 3; ++column) {
    Vec3 e;
    e[column] = 1;
    const Vec3 turned = c * e + s * cross(axis, e) + (1 - c) * dot(axis, e) * axis;
    for (int row = 0; row < 3; ++row) m[row][column] = turned[row];
  }
  return m;
}

}  // namespace eerie::test
