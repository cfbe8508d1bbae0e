#include "solver/run/speed.hpp"

#include <omp.h>

#include <barrier>
#include <thread>
#include <vector>

#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"

namespace eerie::run {

double measured_speed(const Scene& scene, std::size_t jobs, int threads,
                      std::chrono::duration<double> duration) {
  Scene quick = scene;
  quick.numerics.packing = "lattice";
  const particles::State bodies = initial::make_unsettled_impact(quick);
  std::vector<double> speeds(jobs);
  std::barrier together(static_cast<std::ptrdiff_t>(jobs));
  const auto job = [&](std::size_t k) {
    using Clock = std::chrono::steady_clock;
    omp_set_num_threads(threads);
    step::Solver solver(quick, bodies);
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
    std::vector<std::jthread> workers;
    for (std::size_t k = 0; k < jobs; ++k) workers.emplace_back(job, k);
  }
  double sum = 0;
  for (const double speed : speeds) sum += speed;
  return sum;
}

}  // namespace eerie::run
