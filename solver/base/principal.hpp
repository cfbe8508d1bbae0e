#pragma once

#include "solver/base/tensor.hpp"

namespace eerie {

/// Largest eigenvalue of a symmetric tensor: of a stress, the largest tension.
double largest_principal(const SymTensor& s);

/// Sum over the positive eigenvalues s_k of s_k e_k (x) e_k: the tensile part of a stress.
SymTensor positive_part(const SymTensor& s);

}  // namespace eerie
