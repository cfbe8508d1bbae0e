#pragma once

#include "solver/io/snapshot.hpp"

namespace eerie::step {

/// Measures of how sound the numerical state of the rubble is at one moment: what carries its load,
/// and whether its integrated density agrees with the arrangement of its particles.
struct Diagnosis {
  double eos_pressure = 0;      ///< mean over the volume, Pa; friction uses this pressure
  double viscous_pressure = 0;  ///< mean pressure of artificial viscosity, Pa; friction ignores it
  double pressureless = 0;      ///< fraction of the mass without pressure
  double interior = 0;          ///< fraction of the particles that have neighbours on all sides
  double density = 0;           ///< mean integrated density of these particles, kg/m^3
  double summed_density = 0;    ///< mean of sum_j m_j W_ij over these particles, kg/m^3
  /// Root mean square of density/summed_density - 1 over these particles.
  double density_error = 0;
};

/// Costs as much as a few steps. `snapshot` must be in memory order, as a Solver or a file holds
/// it.
Diagnosis diagnose(const io::Snapshot& snapshot);

}  // namespace eerie::step
