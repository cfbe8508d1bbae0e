#pragma once

#include <limits>

#include "solver/base/tensor.hpp"
#include "solver/material/condition.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::material {

/// Hooke's law without a yield strength, in tension too. It serves rubber, waves and oscillations.
class Elastic {
 public:
  static constexpr const char* token = "elastic";
  static constexpr bool is_damaged = false;
  explicit Elastic(const Scene::Material&) {}
  double pressure(double p_eos, const Condition&) const { return p_eos; }
  double yield_stress(double, const Condition& = {}) const {
    return std::numeric_limits<double>::infinity();
  }
  double yield_factor(double, double, const Condition& = {}) const { return 1; }
};

}  // namespace eerie::material
