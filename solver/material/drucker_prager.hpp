#pragma once

#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/material/condition.hpp"
#include "solver/material/yield.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::material {

/// Granular friction of fully damaged material (Drucker & Prager 1952): the deviator may not exceed
/// Y = cohesion + mu_d p. The strength of intact rock (megapascals) would limit Y as well.
/// Pressures in rubble piles (pascals) stay far below, so this law leaves it out; lundborg.hpp has
/// it.
class DruckerPrager {
 public:
  static constexpr const char* token = "drucker-prager";
  static constexpr bool is_damaged = true;  ///< D = 1 at all times

  explicit DruckerPrager(const Scene::Material& m)
      : mu_d_(std::tan(radians(m.drucker_prager.phi_d_deg))),
        cohesion_(m.drucker_prager.cohesion_Pa) {}

  /// The pressure that damaged material carries: none in tension.
  double pressure(double p_eos, const Condition&) const { return damaged_pressure(p_eos, 1); }

  double yield_stress(double p, const Condition& = {}) const { return cohesion_ + mu_d_ * p; }

  double yield_factor(double J2, double p, const Condition& = {}) const {
    return radial_factor(J2, yield_stress(p));
  }

 private:
  double mu_d_, cohesion_;
};

}  // namespace eerie::material
