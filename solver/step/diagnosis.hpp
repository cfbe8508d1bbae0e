#pragma once

#include "solver/io/snapshot.hpp"

namespace eerie::step {

/// How sound the numerical picture of the rubble is at one moment: what carries its load, and
/// whether its density is that of its particles' arrangement.
struct Diagnosis {
  double eos_pressure = 0;      ///< mean over the volume, Pa: what friction feels
  double viscous_pressure = 0;  ///< the same of artificial viscosity, which friction does not feel
  double pressureless = 0;      ///< part of the mass that has no pressure
  double interior = 0;          ///< part of the particles with neighbours on all sides
  double density = 0;           ///< mean of theirs, as integrated, kg/m^3
  double summed_density = 0;    ///< mean of theirs, sum_j m_j W_ij: by their arrangement, kg/m^3
  double density_error = 0;     ///< root mean square of density/summed_density - 1 over them
};

/// Costs a few steps. `snapshot` in memory order, as a Solver or a file holds it.
Diagnosis diagnose(const io::Snapshot& snapshot);

}  // namespace eerie::step
