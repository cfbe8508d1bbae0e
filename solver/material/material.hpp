#pragma once

#include <variant>

#include "solver/base/token.hpp"
#include "solver/material/drucker_prager.hpp"
#include "solver/material/tillotson.hpp"
#include "solver/scene/scene.hpp"

namespace eerie {

/// Every equation of state and rheology; a new one is one file and one entry here (and its
/// token in scene.schema.json). Dispatched once, outside the loops.
using Eos = std::variant<Tillotson>;
using Rheology = std::variant<DruckerPrager, Fluid>;

struct Material {
  Eos eos;
  Rheology rheology;
  double shear_modulus;      ///< Pa
  double reference_density;  ///< kg/m^3

  /// Speed of the longitudinal elastic wave, sqrt((A + 4G/3)/rho0), m/s: the fastest signal.
  double longitudinal_speed() const {
    const double c = std::visit([](const auto& e) { return e.reference_sound_speed(); }, eos);
    const bool sheared = !std::holds_alternative<Fluid>(rheology);
    return std::sqrt(c * c + (sheared ? 4 * shear_modulus / (3 * reference_density) : 0));
  }
};

inline Material make_material(const Scene& scene) {
  const Scene::Material& m = scene.material;
  return {make_by_token<Eos>("scene.material.eos", m.eos, m),
          make_by_token<Rheology>("scene.material.rheology", m.rheology, m),
          m.rheology == Fluid::token ? 0 : m.shear_modulus_Pa, m.rho0_kg_per_m3};
}

}  // namespace eerie
