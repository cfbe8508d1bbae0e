#pragma once

#include <vector>

#include "solver/material/material.hpp"
#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::step {

/// The scene with softer matter. Moduli are multiplied by the square of the factor, so sound speeds
/// by the factor, and time steps grow by its inverse. The stiffness of rubble does not matter while
/// sound is much faster than its motion: density changes by (v/c)^2 only.
Scene softened(Scene scene, const particles::Softening& softening);

/// The state with material of another softening, at the densities that give the same pressures.
/// Particles without pressure keep their density, and all keep their deviatoric stress. `pressure`
/// is that of the state, Pa.
particles::State with_softening(particles::State state, const std::vector<double>& pressure,
                                const Scene& scene, const particles::Softening& softening);

}  // namespace eerie::step
