#pragma once

#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/base/tensor.hpp"
#include "solver/scene/scene.hpp"

namespace eerie {

/// Granular friction of fully damaged material (Drucker & Prager 1952): the deviator may not
/// exceed Y = cohesion + mu_d p. Intact strength (megapascals) would cap Y; pressures of rubble
/// piles (pascals) never come near, so it is left out here.
class DruckerPrager {
 public:
  static constexpr const char* token = "drucker-prager";

  explicit DruckerPrager(const Scene::Material& m)
      : mu_d_(std::tan(radians(m.drucker_prager.phi_d_deg))),
        cohesion_(m.drucker_prager.cohesion_Pa) {}

  /// Pressure that damaged material carries: none in tension, (1 - D) p with D = 1.
  double pressure(double p_eos) const { return p_eos > 0 ? p_eos : 0; }

  double yield_stress(double p) const { return cohesion_ + mu_d_ * p; }

  /// S min(1, Y/sqrt(J2)): radial return to the yield surface.
  SymTensor yielded(const SymTensor& S, double p) const {
    const double Y = yield_stress(p), J2 = second_invariant(S);
    return J2 > Y * Y ? S * (Y / std::sqrt(J2)) : S;
  }

 private:
  double mu_d_, cohesion_;
};

/// No strength at all: the limit of vanishing friction, for comparison.
class Fluid {
 public:
  static constexpr const char* token = "fluid";
  explicit Fluid(const Scene::Material&) {}
  double pressure(double p_eos) const { return p_eos > 0 ? p_eos : 0; }
  double yield_stress(double) const { return 0; }
  SymTensor yielded(const SymTensor&, double) const { return {}; }
};

}  // namespace eerie
