#include "campaign/manager/split.hpp"

#include <algorithm>

#include "solver/run/speed.hpp"

namespace eerie::manager {

std::vector<Split> possible_splits(std::size_t cores, std::size_t pending) {
  std::vector<Split> splits;
  const std::size_t at_most = std::max<std::size_t>(1, std::min(cores, pending));
  for (std::size_t threads = 1; threads <= cores; threads *= 2) {
    const std::size_t jobs = std::min(at_most, cores / threads);
    // More threads for as many jobs: the narrower split would leave cores idle.
    if (!splits.empty() && splits.back().jobs == jobs) splits.pop_back();
    splits.push_back({jobs, static_cast<int>(threads), 0});
  }
  if (splits.back().jobs == 1) splits.back().threads = static_cast<int>(cores);
  return splits;
}

std::vector<Split> measured(std::vector<Split> splits, const Scene& scene,
                            std::chrono::duration<double> duration) {
  for (Split& split : splits)
    split.particle_steps_per_s = run::measured_speed(scene, split.jobs, split.threads, duration);
  std::ranges::stable_sort(splits, std::greater{}, &Split::particle_steps_per_s);
  return splits;
}

}  // namespace eerie::manager
