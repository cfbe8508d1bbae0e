#pragma once

namespace eerie::material {

/// What decides the strength of material besides its pressure. Scenes without an energy equation
/// and without fracture keep these values: cold rubble.
struct Condition {
  double u = 0;       ///< specific internal energy, J/kg
  double damage = 1;  ///< D: 0 intact, 1 rubble
};

/// The pressure that material of damage D carries: the whole of a compression, (1 - D) of a tension
/// (Benz & Asphaug 1995, sec. 2.2).
inline double damaged_pressure(double p_eos, double damage) {
  return p_eos > 0 ? p_eos : (1 - damage) * p_eos;
}

}  // namespace eerie::material
