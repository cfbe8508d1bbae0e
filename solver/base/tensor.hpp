#pragma once

#include <cmath>
#include <type_traits>

#include "solver/base/vec3.hpp"

namespace eerie {

// Every type here is a template over its numbers: double for one particle, or a Pack (simd.hpp) for
// several particles at once.

/// General 3x3 matrix, row-major: m[row][column].
template <class T>
struct Mat3Of {
  T m[3][3] = {};

  static constexpr Mat3Of identity() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }
  constexpr T* operator[](int row) { return m[row]; }
  constexpr const T* operator[](int row) const { return m[row]; }
};
using Mat3 = Mat3Of<double>;

/// Symmetric 3x3 tensor, six stored components.
template <class T>
struct SymTensorOf {
  T xx{}, yy{}, zz{}, xy{}, xz{}, yz{};

  constexpr SymTensorOf& operator+=(const SymTensorOf& o) {
    xx += o.xx, yy += o.yy, zz += o.zz, xy += o.xy, xz += o.xz, yz += o.yz;
    return *this;
  }
  constexpr SymTensorOf& operator*=(T s) {
    xx *= s, yy *= s, zz *= s, xy *= s, xz *= s, yz *= s;
    return *this;
  }
  constexpr bool operator==(const SymTensorOf&) const = default;
};
using SymTensor = SymTensorOf<double>;

/// A tensor in single precision, for arrays whose numbers are no more exact.
using SymTensorf = SymTensorOf<float>;
constexpr SymTensorf to_single(const SymTensor& s) {
  return {static_cast<float>(s.xx), static_cast<float>(s.yy), static_cast<float>(s.zz),
          static_cast<float>(s.xy), static_cast<float>(s.xz), static_cast<float>(s.yz)};
}
constexpr SymTensor to_double(const SymTensorf& s) { return {s.xx, s.yy, s.zz, s.xy, s.xz, s.yz}; }

template <class T>
constexpr SymTensorOf<T> operator+(SymTensorOf<T> a, const SymTensorOf<T>& b) {
  return a += b;
}
template <class T>
constexpr SymTensorOf<T> operator*(SymTensorOf<T> a, std::type_identity_t<T> s) {
  return a *= s;
}
template <class T>
constexpr SymTensorOf<T> operator*(std::type_identity_t<T> s, SymTensorOf<T> a) {
  return a *= s;
}

template <class T>
constexpr T trace(const SymTensorOf<T>& s) {
  return s.xx + s.yy + s.zz;
}

/// s : s, the full double contraction. Each component off the diagonal counts twice.
template <class T>
constexpr T contract(const SymTensorOf<T>& s) {
  return s.xx * s.xx + s.yy * s.yy + s.zz * s.zz + 2 * (s.xy * s.xy + s.xz * s.xz + s.yz * s.yz);
}

/// Second invariant of a deviator, J2 = s:s / 2.
template <class T>
constexpr T second_invariant(const SymTensorOf<T>& s) {
  return contract(s) / 2;
}

template <class T>
constexpr Mat3Of<T> to_matrix(const SymTensorOf<T>& s) {
  return {{{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}}};
}

template <class T>
constexpr T trace(const Mat3Of<T>& a) {
  return a[0][0] + a[1][1] + a[2][2];
}

template <class T>
constexpr Mat3Of<T> operator*(const Mat3Of<T>& a, const Mat3Of<T>& b) {
  Mat3Of<T> c;
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

/// The tensor in axes that a rotation r turns: r s r^T.
constexpr SymTensor turned(const SymTensor& s, const Mat3& r) {
  const Mat3 t = r * to_matrix(s) * transpose(r);
  return {t[0][0], t[1][1], t[2][2], t[0][1], t[0][2], t[1][2]};
}

template <class T>
constexpr T determinant(const SymTensorOf<T>& s) {
  return s.xx * (s.yy * s.zz - s.yz * s.yz) - s.xy * (s.xy * s.zz - s.yz * s.xz) +
         s.xz * (s.xy * s.yz - s.yy * s.xz);
}

/// The inverse by cofactors. `det` is the determinant and must not be 0.
template <class T>
constexpr SymTensorOf<T> inverse(const SymTensorOf<T>& s, T det) {
  const T f = 1 / det;
  return {f * (s.yy * s.zz - s.yz * s.yz), f * (s.xx * s.zz - s.xz * s.xz),
          f * (s.xx * s.yy - s.xy * s.xy), f * (s.xz * s.yz - s.xy * s.zz),
          f * (s.xy * s.yz - s.xz * s.yy), f * (s.xy * s.xz - s.xx * s.yz)};
}

}  // namespace eerie
