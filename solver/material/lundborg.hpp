#pragma once

#include <algorithm>
#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/material/condition.hpp"
#include "solver/material/yield.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::material {

/// Rock between intact and rubble (Lundborg 1968; Collins, Melosh & Ivanov 2004, eqs. 12-16):
///   intact  Y_i = [Y_0 + mu_i p/(1 + mu_i p/(Y_M - Y_0))] (1 - u/u_melt)
///   rubble  Y_d = cohesion + mu_d p, at most Y_i
///   Y = (1 - D) Y_i + D Y_d.
/// Y takes a pressure in tension as zero. Melt has no strength.
class Lundborg {
 public:
  static constexpr const char* token = "lundborg";
  static constexpr bool is_damaged = false;

  explicit Lundborg(const Scene::Material& m)
      : k_(m.lundborg),
        mu_d_(std::tan(radians(m.drucker_prager.phi_d_deg))),
        cohesion_(m.drucker_prager.cohesion_Pa) {}

  double pressure(double p_eos, const Condition& state) const {
    return damaged_pressure(p_eos, state.damage);
  }

  double yield_stress(double p, const Condition& state) const {
    const double compression = std::max(p, 0.0), friction = k_.mu_i * compression;
    const double cold = k_.Y_0_Pa + friction / (1 + friction / (k_.Y_M_Pa - k_.Y_0_Pa));
    const double intact = cold * std::max(0.0, 1 - state.u / k_.u_melt_J_per_kg);
    const double rubble = std::min(cohesion_ + mu_d_ * compression, intact);
    return (1 - state.damage) * intact + state.damage * rubble;
  }

  double yield_factor(double J2, double p, const Condition& state) const {
    return radial_factor(J2, yield_stress(p, state));
  }

 private:
  Scene::Lundborg k_;
  double mu_d_, cohesion_;
};

}  // namespace eerie::material
