#pragma once

#include <vector>

#include "campaign/sweep.hpp"
#include "db/rows.hpp"
#include "solver/scene/scene.hpp"

namespace eerie {

/// Mutual escape speed of the two bodies at contact, sqrt(2 G (M_t + M_i) / (R_t + R_i)), m/s.
double mutual_escape_speed(const Scene& scene);

/// Particles times steps that a run takes at the step dt = cfl h / c_l, with the longitudinal
/// wave speed c_l = sqrt((A + 4 G / 3) / rho0). A real run takes somewhat more, since a fast
/// compression shortens its steps.
double expected_particle_steps(const Scene& scene);

/// The job that computes a scene.
db::NewJob new_job(const Scene& scene);

/// The distinct jobs of a sweep. Throws InputError.
std::vector<db::NewJob> jobs_of(const Sweep& sweep);

}  // namespace eerie
