#pragma once

#include <cmath>

#include "solver/material/eos_point.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::material {

/// p = (gamma - 1) rho u, for tests of shocks and energy. Needs material.energy "integrated".
class IdealGas {
 public:
  static constexpr const char* token = "ideal-gas";
  static constexpr bool is_cold = false;  ///< pressure comes from heat alone

  explicit IdealGas(const Scene::Material& m)
      : gamma_(m.ideal_gas.gamma), rho0_(m.rho0_kg_per_m3) {}

  /// rho in kg/m^3 > 0, u in J/kg >= 0; c^2 = gamma p/rho.
  EosPoint operator()(double rho, double u) const {
    const double p = (gamma_ - 1) * rho * u;
    return {p, std::sqrt(gamma_ * p / rho)};
  }

  double reference_density() const { return rho0_; }
  double reference_sound_speed() const { return 0; }
  /// A cold gas resists nothing: bodies of it start at the reference density.
  double density_at(double) const { return rho0_; }

 private:
  double gamma_, rho0_;
};

}  // namespace eerie::material
