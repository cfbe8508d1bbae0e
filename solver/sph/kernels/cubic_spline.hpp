#pragma once

#include "solver/sph/kernels/polynomial.hpp"

namespace eerie::sph {

/// The cubic spline M4 (Monaghan & Lattanzio 1985).
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

}  // namespace eerie::sph
