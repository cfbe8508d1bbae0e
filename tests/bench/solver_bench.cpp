#include <benchmark/benchmark.h>
#include <omp.h>

#include "tests/bench/bodies.hpp"

// The stages of a step and the whole step, one thread. Figures are comparable within one run only:
// quote ratios. The rate is particles (or particle-steps) per second.

namespace eerie {
namespace {

void count(benchmark::State& run, double particles_per_iteration) {
  run.counters["particles"] =
      benchmark::Counter(particles_per_iteration, benchmark::Counter::kIsIterationInvariantRate);
}

/// One cycle of the first approach: lists, sums, material, gravity, everything.
void WholeStep(benchmark::State& run, const std::string& precision) {
  omp_set_num_threads(1);
  const Scene scene = bench::scene(run.range(0), precision);
  Solver solver(scene, bench::bodies(run.range(0)));
  for (auto _ : run) solver.cycle(1e9);
  run.counters["particles"] = benchmark::Counter(
      static_cast<double>(solver.state().size()) * static_cast<double>(solver.state().step),
      benchmark::Counter::kIsRate);
  for (std::size_t k = 0; k < stage_count; ++k)
    run.counters[std::string(stage_names[k]) + "_ns"] =
        1e9 * solver.stages().seconds[k] /
        (static_cast<double>(solver.state().step) * static_cast<double>(solver.state().size()));
}
BENCHMARK_CAPTURE(WholeStep, float_sums, "float")->Arg(1000)->Arg(5000)->Arg(50000)->MinTime(2);
BENCHMARK_CAPTURE(WholeStep, double_sums, "double")->Arg(5000)->Arg(50000)->MinTime(2);

void GravityWalk(benchmark::State& run) {
  omp_set_num_threads(1);
  const State& bodies = bench::bodies(run.range(0));
  const double theta = static_cast<double>(run.range(1)) / 100;
  KdTree tree(bodies.size());
  tree.fit(bodies.x);
  Gravity gravity({bodies.mass, bodies.h, theta});
  std::vector<Vec3> g;
  for (auto _ : run) gravity.accelerations(tree, bodies.x, g);
  count(run, static_cast<double>(bodies.size()));
}
BENCHMARK(GravityWalk)
    ->ArgsProduct({{1000, 5000, 50000}, {25, 35, 50, 70}})
    ->ArgNames({"n", "theta%"});

void ListBuild(benchmark::State& run) {
  omp_set_num_threads(1);
  const State& bodies = bench::bodies(run.range(0));
  KdTree tree(bodies.size());
  tree.fit(bodies.x);
  NeighbourList lists(2 * bodies.h, 0.2 * bodies.h);
  for (auto _ : run) lists.build(tree, bodies.x);
  count(run, static_cast<double>(bodies.size()));
}
BENCHMARK(ListBuild)->Arg(1000)->Arg(5000)->Arg(50000);

void Reorder(benchmark::State& run) {
  const State& bodies = bench::bodies(run.range(0));
  for (auto _ : run) benchmark::DoNotOptimize(kd_order(bodies.x, bodies.id));
  count(run, static_cast<double>(bodies.size()));
}
BENCHMARK(Reorder)->Arg(5000)->Arg(50000);

void MakeBody(benchmark::State& run) {
  const Scene scene = bench::scene(run.range(0));
  for (auto _ : run) benchmark::DoNotOptimize(make_body(scene, Body::target));
  count(run, static_cast<double>(run.range(0)));
}
BENCHMARK(MakeBody)->Arg(1000)->Arg(5000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace eerie
