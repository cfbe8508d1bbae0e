#pragma once

#include <vector>

#include "campaign/sweeps/sweep.hpp"
#include "db/jobs/rows.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::sweeps {

/// Mutual escape speed of the two bodies at contact, sqrt(2 G (M_t + M_i) / (R_t + R_i)), m/s.
double mutual_escape_speed(const Scene& scene);

/// Simulated time, s, at which a run is likely to end: end.time_s, or what is typical of impacts
/// where the scene lets it end once it has settled.
double expected_end_s(const Scene& scene);

/// Particles times steps that a run takes at the step dt = cfl h / c_l, with the longitudinal
/// wave speed c_l = sqrt((A + 4 G / 3) / rho0). A real run takes somewhat more, since a fast
/// compression shortens its steps.
double expected_particle_steps(const Scene& scene);

/// The job that computes a scene.
db::NewJob new_job(const Scene& scene);

/// The distinct jobs of the scenes of a sweep.
std::vector<db::NewJob> identify(const std::vector<Scene>& scenes);

/// The same, to be run in the order of the scenes: each has a lower priority than the one before.
std::vector<db::NewJob> jobs_in_order(const std::vector<Scene>& scenes);

/// The warnings (solver/scene/guards.hpp) of all scenes, each once, with how many it concerns.
std::vector<std::string> cautions(const std::vector<Scene>& scenes);

}  // namespace eerie::sweeps
