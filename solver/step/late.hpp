#pragma once

#include <vector>

#include "solver/material/material.hpp"
#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::step {

/// The scene of softened matter: moduli times the square of the factor, so sound speeds times it
/// and time steps over it, and the alpha of viscosity. The stiffness of rubble does not matter as
/// long as sound is much faster than what moves: density then changes by (v/c)^2 only.
Scene softened(Scene scene, const particles::Softening& softening);

/// The state with material of another softening and the densities at which that has the same
/// pressures. What has no pressure, and the deviatoric stress, stay. `pressure`:
/// of the state, Pa.
particles::State with_softening(particles::State state, const std::vector<double>& pressure,
                                const Scene& scene, const particles::Softening& softening);

}  // namespace eerie::step
