#pragma once

#include <cmath>

#include "solver/base/tensor.hpp"

namespace eerie {

/// S min(1, Y/sqrt(J2)), J2 = S:S/2: the deviator returns radially to the yield surface.
inline SymTensor radial_return(const SymTensor& S, double Y) {
  const double J2 = second_invariant(S);
  return J2 > Y * Y ? S * (Y / std::sqrt(J2)) : S;
}

}  // namespace eerie
