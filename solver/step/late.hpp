#pragma once

#include <vector>

#include "solver/material/material.hpp"
#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::step {

/// The scene of a late phase. Moduli are multiplied by the square of `factor`, so sound speeds by
/// `factor`, and time steps grow by its inverse. Once bodies hardly move, the stiffness of rubble
/// does not matter, as long as the rubble stays stiff against its own weight and against what still
/// falls on it.
Scene softened(Scene scene, double factor);

/// The state with material of another `softening` (1: the material of the scene), at the densities
/// that give the same pressures. Particles without pressure keep their density, and all keep their
/// deviatoric stress. `pressure` is that of the state, Pa.
particles::State with_softening(particles::State state, const std::vector<double>& pressure,
                                const Scene& scene, double softening);

/// The state at the beginning of its late phase, with the softening numerics.late_sound_speed.
particles::State softened(particles::State state, const std::vector<double>& pressure,
                          const Scene& scene);

}  // namespace eerie::step
