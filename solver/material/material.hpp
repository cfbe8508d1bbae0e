#pragma once

#include <cmath>
#include <optional>
#include <variant>

#include "solver/base/token.hpp"
#include "solver/material/drucker_prager.hpp"
#include "solver/material/elastic.hpp"
#include "solver/material/fluid.hpp"
#include "solver/material/grady_kipp.hpp"
#include "solver/material/ideal_gas.hpp"
#include "solver/material/linear_eos.hpp"
#include "solver/material/lundborg.hpp"
#include "solver/material/tillotson.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::material {

/// The law without fracture: damage keeps the value that the rheology assumes, at no cost.
struct NoFracture {
  static constexpr const char* token = "none";
  explicit NoFracture(const Scene::Material&) {}
};

/// The lists of all equations of state, rheologies and laws of fracture. A new law is one file, one
/// entry here and its token in scene.schema.json. The solver picks the alternative once, outside
/// its loops.
using Eos = std::variant<Tillotson, LinearEos, IdealGas>;
using Rheology = std::variant<DruckerPrager, Fluid, Elastic, Lundborg>;
using Fracture = std::variant<NoFracture, GradyKipp>;

struct Material {
  Eos eos;
  Rheology rheology;
  Fracture fracture;
  double shear_modulus;      ///< G, Pa
  double reference_density;  ///< kg/m^3
  double cohesion;           ///< Pa

  double reference_sound_speed() const {
    return std::visit([](const auto& e) { return e.reference_sound_speed(); }, eos);
  }
  /// The speed of the longitudinal elastic wave, sqrt(c0^2 + 4G/(3 rho0)), m/s. No signal is
  /// faster.
  double longitudinal_speed() const {
    const double c = reference_sound_speed();
    return std::sqrt(c * c + 4 * shear_modulus / (3 * reference_density));
  }
  /// Young's modulus E = 9 K G/(3 K + G), Pa, where K is the bulk modulus of the uncompressed
  /// material.
  double young_modulus() const {
    const double c = reference_sound_speed(), K = reference_density * c * c;
    return 9 * K * shear_modulus / (3 * K + shear_modulus);
  }
  /// Whether a free surface can carry stress, through tensile strength or cohesion.
  bool stressed_surface() const { return initial_damage() < 1 || cohesion > 0; }
  /// Whether gaps in the material stay empty. A gas fills them.
  bool closes_gaps() const {
    return std::visit([](const auto& e) { return e.is_cold; }, eos);
  }
  /// The damage of a particle that has not fractured yet.
  double initial_damage() const {
    return std::visit([](const auto& r) { return r.is_damaged ? 1.0 : 0.0; }, rheology);
  }
};

inline Material make_material(const Scene::Material& m) {
  return {make_by_token<Eos>("scene.material.eos", m.eos, m),
          make_by_token<Rheology>("scene.material.rheology", m.rheology, m),
          make_by_token<Fracture>("scene.material.fracture", m.fracture, m),
          m.rheology == Fluid::token ? 0 : m.shear_modulus_Pa,
          m.rho0_kg_per_m3,
          m.drucker_prager.cohesion_Pa};
}

}  // namespace eerie::material
