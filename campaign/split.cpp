#include "campaign/split.hpp"

#include <omp.h>

#include <algorithm>
#include <barrier>
#include <thread>

#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"

namespace eerie {

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

double measured_speed(const Split& split, const Scene& scene,
                      std::chrono::duration<double> duration) {
  Scene quick = scene;
  quick.numerics.packing = "lattice";
  const State bodies = make_unsettled_impact(quick);
  std::vector<double> speeds(split.jobs);
  std::barrier together(static_cast<std::ptrdiff_t>(split.jobs));
  const auto job = [&](std::size_t k) {
    using Clock = std::chrono::steady_clock;
    omp_set_num_threads(split.threads);
    Solver solver(quick, bodies);
    const long before = solver.state().step;
    together.arrive_and_wait();
    const auto start = Clock::now();
    std::chrono::duration<double> elapsed{};
    while (elapsed < duration) {
      solver.cycle(1e9);
      elapsed = Clock::now() - start;
    }
    speeds[k] = static_cast<double>(solver.state().step - before) *
                static_cast<double>(bodies.size()) / elapsed.count();
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t k = 0; k < split.jobs; ++k) threads.emplace_back(job, k);
  }
  double sum = 0;
  for (const double speed : speeds) sum += speed;
  return sum;
}

std::vector<Split> measured_splits(std::size_t cores, std::size_t pending, const Scene& scene,
                                   std::chrono::duration<double> duration) {
  std::vector<Split> splits = possible_splits(cores, pending);
  for (Split& split : splits) split.particle_steps_per_s = measured_speed(split, scene, duration);
  std::ranges::stable_sort(splits, std::greater{}, &Split::particle_steps_per_s);
  return splits;
}

}  // namespace eerie
