#pragma once

#include <chrono>
#include <cstddef>

#include "solver/scene/scene.hpp"

namespace eerie::run {

/// Measures particle-steps per second. For `duration` this process runs `jobs` impacts such as
/// `scene` side by side, each with `threads` threads.
double measured_speed(const Scene& scene, std::size_t jobs, int threads,
                      std::chrono::duration<double> duration);

}  // namespace eerie::run
