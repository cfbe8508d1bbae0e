#pragma once

#include "solver/base/tensor.hpp"

namespace eerie {

/// The largest eigenvalue of a symmetric tensor. For a stress this is the largest tension.
double largest_principal(const SymTensor& s);

/// The sum of s_k e_k (x) e_k over the positive eigenvalues s_k. For a stress this is its tensile
/// part.
SymTensor positive_part(const SymTensor& s);

}  // namespace eerie
