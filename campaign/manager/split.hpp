#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "solver/scene/scene.hpp"

namespace eerie::manager {

/// A way to share the cores of a machine: the number of jobs at a time, and of threads for each.
struct Split {
  std::size_t jobs = 1;
  int threads = 1;
  double particle_steps_per_s = 0;  ///< of all jobs together; 0 where it is not measured
};

/// The splits to consider: 1, 2, 4... threads per job, and as many jobs as `cores` and `pending`
/// allow. A split is left out where it leaves cores idle that fewer jobs could use. The first has
/// the most jobs.
std::vector<Split> possible_splits(std::size_t cores, std::size_t pending);

/// Measures each split for `duration` on impacts such as `scene`. Returns them with their speeds,
/// the fastest first.
std::vector<Split> measured(std::vector<Split> splits, const Scene& scene,
                            std::chrono::duration<double> duration);

}  // namespace eerie::manager
