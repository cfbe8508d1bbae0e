#pragma once

namespace eerie::material {

/// What besides pressure decides the strength of a piece of material. Scenes without an energy
/// equation or fracture never change it: cold rubble.
struct Condition {
  double u = 0;       ///< specific internal energy, J/kg
  double damage = 1;  ///< D: 0 intact, 1 rubble
};

/// Pressure that material of damage D carries: all compression, (1 - D) of a tension
/// (Benz & Asphaug 1995, sec. 2.2).
inline double damaged_pressure(double p_eos, double damage) {
  return p_eos > 0 ? p_eos : (1 - damage) * p_eos;
}

}  // namespace eerie::material
