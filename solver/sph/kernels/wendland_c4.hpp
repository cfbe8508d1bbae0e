#pragma once

#include "solver/sph/kernels/polynomial.hpp"

namespace eerie::sph {

/// Wendland's C4 kernel (Dehnen & Aly 2012, table 1), with support 2h.
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

}  // namespace eerie::sph
