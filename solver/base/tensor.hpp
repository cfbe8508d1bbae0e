#pragma once

#include <cmath>

#include "solver/base/vec3.hpp"

namespace eerie {

/// General 3x3 matrix, row-major: m[row][column].
struct Mat3 {
  double m[3][3] = {};

  static constexpr Mat3 identity() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }
  constexpr double* operator[](int row) { return m[row]; }
  constexpr const double* operator[](int row) const { return m[row]; }
};

/// Symmetric 3x3 tensor, six stored components.
struct SymTensor {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  constexpr SymTensor& operator+=(const SymTensor& o) {
    xx += o.xx, yy += o.yy, zz += o.zz, xy += o.xy, xz += o.xz, yz += o.yz;
    return *this;
  }
  constexpr SymTensor& operator*=(double s) {
    xx *= s, yy *= s, zz *= s, xy *= s, xz *= s, yz *= s;
    return *this;
  }
  constexpr bool operator==(const SymTensor&) const = default;
};

constexpr SymTensor operator+(SymTensor a, const SymTensor& b) { return a += b; }
constexpr SymTensor operator*(SymTensor a, double s) { return a *= s; }
constexpr SymTensor operator*(double s, SymTensor a) { return a *= s; }

constexpr double trace(const SymTensor& s) { return s.xx + s.yy + s.zz; }

/// s : s, the full double contraction (off-diagonals count twice).
constexpr double contract(const SymTensor& s) {
  return s.xx * s.xx + s.yy * s.yy + s.zz * s.zz + 2 * (s.xy * s.xy + s.xz * s.xz + s.yz * s.yz);
}

/// Second invariant of a deviator, J2 = s:s / 2.
constexpr double second_invariant(const SymTensor& s) { return contract(s) / 2; }

constexpr Mat3 to_matrix(const SymTensor& s) {
  return {{{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}}};
}

constexpr double trace(const Mat3& a) { return a[0][0] + a[1][1] + a[2][2]; }

/// a : b, the sum of a_ij b_ij.
constexpr double contract(const Mat3& a, const Mat3& b) {
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum += a[i][j] * b[i][j];
  return sum;
}

constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
  Mat3 c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return c;
}

constexpr Vec3 operator*(const Mat3& a, const Vec3& v) {
  return {a[0][0] * v.x + a[0][1] * v.y + a[0][2] * v.z,
          a[1][0] * v.x + a[1][1] * v.y + a[1][2] * v.z,
          a[2][0] * v.x + a[2][1] * v.y + a[2][2] * v.z};
}

constexpr Mat3 transpose(const Mat3& a) {
  return {{{a[0][0], a[1][0], a[2][0]}, {a[0][1], a[1][1], a[2][1]}, {a[0][2], a[1][2], a[2][2]}}};
}

constexpr double determinant(const SymTensor& s) {
  return s.xx * (s.yy * s.zz - s.yz * s.yz) - s.xy * (s.xy * s.zz - s.yz * s.xz) +
         s.xz * (s.xy * s.yz - s.yy * s.xz);
}

/// Inverse by cofactors, given the determinant (must not be 0).
constexpr SymTensor inverse(const SymTensor& s, double det) {
  const double f = 1 / det;
  return {f * (s.yy * s.zz - s.yz * s.yz), f * (s.xx * s.zz - s.xz * s.xz),
          f * (s.xx * s.yy - s.xy * s.xy), f * (s.xz * s.yz - s.xy * s.zz),
          f * (s.xy * s.yz - s.xz * s.yy), f * (s.xy * s.xz - s.xx * s.yz)};
}

}  // namespace eerie
