#pragma once

#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::step {

/// Totals of the whole system about the origin of coordinates (the centre of mass at the start), in
/// SI. Sums run in the order of ids, so they do not depend on the memory order.
struct Totals {
  double mass = 0;
  Vec3 momentum, angular_momentum;
  double kinetic_energy = 0, potential_energy = 0;
  // These are 0 without an energy equation. The internal energy contains both heats and the elastic
  // energies of shear and of compression.
  double internal_energy = 0, viscous_heat = 0, friction_heat = 0, shear_energy = 0;

  double energy() const { return kinetic_energy + potential_energy + internal_energy; }
};

/// `state` must be in memory order (as a Solver or a snapshot holds it).
Totals totals(const Scene& scene, const particles::State& state);

}  // namespace eerie::step
