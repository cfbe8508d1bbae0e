#pragma once

#include <vector>

#include "solver/material/material.hpp"
#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::step {

/// The scene of a late phase: moduli times the square of `factor`, so sound speeds times it and
/// time steps over it. Once bodies hardly move, the stiffness of rubble does not matter as long as
/// it stays stiff against its own weight and against what still falls on it.
Scene softened(Scene scene, double factor);

/// The state with material of another `softening` (1: that of the scene) and the densities at which
/// that has the same pressures. What has no pressure, and the deviatoric stress, stay. `pressure`:
/// of the state, Pa.
particles::State with_softening(particles::State state, const std::vector<double>& pressure,
                                const Scene& scene, double softening);

/// The state as it enters its late phase: numerics.late_sound_speed softer.
particles::State softened(particles::State state, const std::vector<double>& pressure,
                          const Scene& scene);

}  // namespace eerie::step
