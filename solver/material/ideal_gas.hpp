#pragma once

#include <cmath>

#include "solver/material/eos_point.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::material {

/// The ideal gas, p = (gamma - 1) rho u, for tests of shocks and energy. It needs material.energy
/// "integrated".
class IdealGas {
 public:
  static constexpr const char* token = "ideal-gas";
  static constexpr bool is_cold = false;  ///< all pressure comes from heat

  explicit IdealGas(const Scene::Material& m)
      : gamma_(m.ideal_gas.gamma), rho0_(m.rho0_kg_per_m3) {}

  /// p and c at rho > 0 (kg/m^3) and u >= 0 (J/kg); c^2 = gamma p/rho.
  EosPoint operator()(double rho, double u) const {
    const double p = (gamma_ - 1) * rho * u;
    return {p, std::sqrt(gamma_ * p / rho)};
  }

  double reference_density() const { return rho0_; }
  double reference_sound_speed() const { return 0; }
  /// A cold gas resists no compression, so its bodies start at the reference density.
  double density_at(double) const { return rho0_; }

 private:
  double gamma_, rho0_;
};

}  // namespace eerie::material
