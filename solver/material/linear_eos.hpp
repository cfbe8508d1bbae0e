#pragma once

#include <cmath>

#include "solver/material/eos_point.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::material {

/// Hooke's law for small changes of volume, in tension and in compression: p = c0^2 (rho - rho0)
/// with c0^2 = K/rho0 (Gray, Monaghan & Swift 2001, eq. 2.8). It serves elastic tests.
class LinearEos {
 public:
  static constexpr const char* token = "linear";
  static constexpr bool is_cold = true;

  explicit LinearEos(const Scene::Material& m)
      : K_(m.linear.bulk_modulus_Pa), rho0_(m.rho0_kg_per_m3) {}

  EosPoint operator()(double rho, double) const {
    return {K_ * (rho / rho0_ - 1), reference_sound_speed()};
  }

  double reference_density() const { return rho0_; }
  double reference_sound_speed() const { return std::sqrt(K_ / rho0_); }
  double density_at(double p) const { return rho0_ * (1 + p / K_); }

 private:
  double K_, rho0_;
};

}  // namespace eerie::material
