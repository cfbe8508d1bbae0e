#pragma once

#include <cmath>

#include "solver/base/tensor.hpp"

namespace eerie::material {

// Every rheology scales the deviator S back to its yield surface: S becomes yield_factor(J2, p,
// condition) S, where J2 = S:S/2.

/// The factor min(1, Y/sqrt(J2)).
inline double radial_factor(double J2, double Y) { return J2 > Y * Y ? Y / std::sqrt(J2) : 1; }

template <class Rheology, class... Condition>
SymTensor yielded(const Rheology& rheology, const SymTensor& S, double p,
                  const Condition&... condition) {
  return rheology.yield_factor(second_invariant(S), p, condition...) * S;
}

}  // namespace eerie::material
