#pragma once

#include <type_traits>

#include "solver/base/constants.hpp"
#include "solver/base/simd/pack.hpp"

namespace eerie::sph {

// Kernels are functions of q = r/h with support 2h: W = normalisation / h^3 * w(q), with the
// gradient dW/dx = normalisation / h^5 * dw_over_q(q) * (x_i - x_j). They are truncated polynomials
// without branches, zero beyond the support. P is a number or a Pack of numbers.

/// A constant in the precision of P, a number or a Pack.
template <class P>
P splat_like(double value) {
  if constexpr (std::is_arithmetic_v<P>)
    return static_cast<P>(value);
  else
    return P{} + static_cast<std::remove_cvref_t<decltype(P{}[0])>>(value);
}

}  // namespace eerie::sph
