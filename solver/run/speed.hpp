#pragma once

#include <chrono>
#include <cstddef>

#include "solver/scene/scene.hpp"

namespace eerie::run {

/// Particle-steps per second of `jobs` runs of impacts such as `scene`, side by side in this
/// process with `threads` threads each, over `duration`.
double measured_speed(const Scene& scene, std::size_t jobs, int threads,
                      std::chrono::duration<double> duration);

}  // namespace eerie::run
