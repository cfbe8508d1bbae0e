#pragma once

#include <vector>

#include "campaign/sweeps/sweep.hpp"
#include "db/jobs/rows.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::sweeps {

/// The mutual escape speed of the two bodies at contact, sqrt(2 G (M_t + M_i) / (R_t + R_i)), m/s.
double mutual_escape_speed(const Scene& scene);

/// The simulated time, s, at which a run is likely to end. It is end.time_s, or a typical time for
/// impacts where the scene lets a run end once it has settled.
double expected_end_s(const Scene& scene);

/// The particle-steps of a run with the step dt = cfl h / c_l, where c_l = sqrt((A + 4 G / 3) /
/// rho0) is the speed of the longitudinal wave. An actual run takes somewhat more, since fast
/// compression shortens its steps.
double expected_particle_steps(const Scene& scene);

/// The job that computes a scene.
db::NewJob new_job(const Scene& scene);

/// The distinct jobs of the scenes of a sweep.
std::vector<db::NewJob> identify(const std::vector<Scene>& scenes);

/// The distinct jobs of scenes that should run in this order: each job has a lower priority than
/// the one before.
std::vector<db::NewJob> jobs_in_order(const std::vector<Scene>& scenes);

/// The warnings (solver/scene/guards.hpp) of all scenes. Each appears once, with the number of
/// scenes that it concerns.
std::vector<std::string> cautions(const std::vector<Scene>& scenes);

}  // namespace eerie::sweeps
