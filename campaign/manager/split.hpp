#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "solver/scene/scene.hpp"

namespace eerie::manager {

/// How the cores of a machine are shared: so many jobs at a time, with so many threads each.
struct Split {
  std::size_t jobs = 1;
  int threads = 1;
  double particle_steps_per_s = 0;  ///< of all jobs together; 0 where it was not measured
};

/// Splits worth a look: 1, 2, 4... threads per job and as many jobs as `cores` and `pending` allow.
/// Those that leave cores idle though fewer jobs could use them are left out. The first has the
/// most jobs.
std::vector<Split> possible_splits(std::size_t cores, std::size_t pending);

/// The splits with their speeds on impacts such as `scene`, each measured for `duration`; the
/// fastest first.
std::vector<Split> measured(std::vector<Split> splits, const Scene& scene,
                            std::chrono::duration<double> duration);

}  // namespace eerie::manager
