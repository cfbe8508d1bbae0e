#pragma once

#include <string>
#include <variant>

#include "solver/base/token.hpp"
#include "solver/sph/kernels/cubic_spline.hpp"
#include "solver/sph/kernels/wendland_c2.hpp"
#include "solver/sph/kernels/wendland_c4.hpp"

namespace eerie::sph {

/// The list of all kernels. A new kernel is one file in kernels/, one entry here and its token in
/// scene.schema.json.
using KernelChoice = std::variant<CubicSpline, WendlandC2, WendlandC4>;

inline KernelChoice make_kernel(const std::string& token) {
  return make_by_token<KernelChoice>("scene.numerics.kernel", token);
}

}  // namespace eerie::sph
