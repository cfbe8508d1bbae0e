#pragma once

#include "solver/base/tensor.hpp"
#include "solver/material/condition.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::material {

/// Material without strength: the limit of vanishing friction, and gases.
class Fluid {
 public:
  static constexpr const char* token = "fluid";
  static constexpr bool is_damaged = true;
  explicit Fluid(const Scene::Material&) {}
  double pressure(double p_eos, const Condition&) const { return damaged_pressure(p_eos, 1); }
  double yield_stress(double, const Condition& = {}) const { return 0; }
  double yield_factor(double, double, const Condition& = {}) const { return 0; }
};

}  // namespace eerie::material
