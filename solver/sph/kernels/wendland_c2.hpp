#pragma once

#include "solver/sph/kernels/polynomial.hpp"

namespace eerie::sph {

/// Wendland's C2 kernel (Dehnen & Aly 2012, table 1), with support 2h.
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

}  // namespace eerie::sph
