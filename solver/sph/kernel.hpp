#pragma once

#include <string>
#include <type_traits>
#include <variant>

#include "solver/base/constants.hpp"
#include "solver/base/simd.hpp"
#include "solver/base/token.hpp"

namespace eerie {

// Kernels with support 2h as functions of q = r/h: W = normalisation / h^3 * w(q), and the
// gradient dW/dx = normalisation / h^5 * dw_over_q(q) * (x_i - x_j). Branch-free: truncated
// polynomials, zero beyond the support. P is a number or a Pack of numbers.

/// A constant in the precision of P, a number or a Pack.
template <class P>
P splat_like(double value) {
  if constexpr (std::is_arithmetic_v<P>)
    return static_cast<P>(value);
  else
    return P{} + static_cast<std::remove_cvref_t<decltype(P{}[0])>>(value);
}

/// M4 cubic spline (Monaghan & Lattanzio 1985).
struct CubicSpline {
  static constexpr const char* token = "cubic-spline";
  static constexpr double normalisation = 1 / pi;
  template <class P>
  static P w(P q) {
    const P outer = positive_part(2 - q), inner = positive_part(1 - q);
    return P(outer * outer * outer * 0.25f - inner * inner * inner);
  }
  template <class P>
  static P dw_over_q(P q, P inverse_q) {
    const P outer = positive_part(2 - q), inner = positive_part(1 - q);
    return (3 * inner * inner - 0.75f * outer * outer) * inverse_q;
  }
};

/// Wendland C2 (Dehnen & Aly 2012, table 1; support 2h).
struct WendlandC2 {
  static constexpr const char* token = "wendland-c2";
  static constexpr double normalisation = 21 / (16 * pi);
  template <class P>
  static P w(P q) {
    const P s = positive_part(1 - 0.5f * q), s2 = s * s;
    return s2 * s2 * (2 * q + 1);
  }
  template <class P>
  static P dw_over_q(P q, P) {
    const P s = positive_part(1 - 0.5f * q);
    return -5 * s * s * s;
  }
};

/// Wendland C4 (Dehnen & Aly 2012, table 1; support 2h).
struct WendlandC4 {
  static constexpr const char* token = "wendland-c4";
  static constexpr double normalisation = 495 / (256 * pi);
  template <class P>
  static P w(P q) {
    const P s = positive_part(1 - 0.5f * q), s2 = s * s;
    return s2 * s2 * s2 * (splat_like<P>(35. / 12) * q * q + 3 * q + 1);
  }
  template <class P>
  static P dw_over_q(P q, P) {
    const P s = positive_part(1 - 0.5f * q), s2 = s * s;
    return splat_like<P>(-14. / 3) * s2 * s2 * s * (1 + 2.5f * q);
  }
};

/// Every kernel; a new one is one struct and one entry here.
using KernelChoice = std::variant<CubicSpline, WendlandC2, WendlandC4>;

inline KernelChoice make_kernel(const std::string& token) {
  return make_by_token<KernelChoice>("scene.numerics.kernel", token);
}

}  // namespace eerie
