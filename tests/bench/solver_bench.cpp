#include <benchmark/benchmark.h>
#include <omp.h>

#include <filesystem>

#include "solver/run/run.hpp"
#include "tests/bench/bodies.hpp"

// The stages of a step and the whole step, one thread. Figures are comparable within one run only:
// quote ratios. The rate is particles (or particle-steps) per second.

namespace eerie {
namespace {

using namespace particles;
using namespace step;
using namespace run;
using namespace tree;
using namespace initial;

void count(benchmark::State& run, double particles_per_iteration) {
  run.counters["particles"] =
      benchmark::Counter(particles_per_iteration, benchmark::Counter::kIsIterationInvariantRate);
}

void count_stages(benchmark::State& run, const StageTimes& stages, double particle_steps) {
  for (std::size_t k = 0; k < stage_count; ++k)
    run.counters[std::string(stage_names[k]) + "_ns"] = 1e9 * stages.seconds[k] / particle_steps;
}

/// The reference impact as `eerie solve` runs it, snapshots, history and checkpoints included, from
/// the start to `end_s`; without the making of the bodies.
void ReferenceImpact(benchmark::State& run, const std::string& precision, double end_s) {
  const auto threads = static_cast<int>(run.range(1));
  Scene scene = bench::scene(run.range(0), precision);
  scene.end.time_s = end_s;
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "eerie-bench";
  RunSummary summary;
  for (auto _ : run) {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    RunOptions options;
    options.directory = folder;
    options.threads = threads;
    summary = run_impact(scene, options);
    run.SetIterationTime(summary.stages.total());
  }
  std::filesystem::remove_all(folder);
  const double steps = summary.steps_here * static_cast<double>(summary.last.state.size());
  run.counters["M_particle_steps_per_s_core"] = steps / threads / summary.stages.total() / 1e6;
  count_stages(run, summary.stages, steps);
}
#define REFERENCE_IMPACT(precision, n, threads, end_s)             \
  BENCHMARK_CAPTURE(ReferenceImpact, precision, #precision, end_s) \
      ->Args({n, threads})                                         \
      ->ArgNames({"", "threads"})                                  \
      ->Iterations(1)                                              \
      ->UseManualTime()                                            \
      ->Unit(benchmark::kSecond)
REFERENCE_IMPACT(float, 1000, 1, 30000);
REFERENCE_IMPACT(float, 5000, 1, 3000);
REFERENCE_IMPACT(double, 5000, 1, 3000);
REFERENCE_IMPACT(float, 50000, 1, 120);
REFERENCE_IMPACT(double, 50000, 1, 60);
REFERENCE_IMPACT(float, 50000, 2, 120);

/// One cycle of the first approach, when lists and gravity are at their busiest.
void WholeStep(benchmark::State& run, const std::string& precision) {
  omp_set_num_threads(1);
  const Scene scene = bench::scene(run.range(0), precision);
  Solver solver(scene, bench::bodies(run.range(0)));
  for (auto _ : run) solver.cycle(1e9);
  const double particle_steps =
      static_cast<double>(solver.state().size()) * static_cast<double>(solver.state().step);
  run.counters["particle_steps"] = benchmark::Counter(particle_steps, benchmark::Counter::kIsRate);
  count_stages(run, solver.stages(), particle_steps);
}
BENCHMARK_CAPTURE(WholeStep, float_sums, "float")->Arg(1000)->Arg(5000)->Arg(50000)->MinTime(2);
BENCHMARK_CAPTURE(WholeStep, double_sums, "double")->Arg(5000)->Arg(50000)->MinTime(2);

/// How the cost of a step grows with the number of particles: unsettled bodies, which cost the
/// same.
void Scaling(benchmark::State& run) {
  omp_set_num_threads(1);
  Scene scene = bench::scene(run.range(0));
  scene.numerics.packing = "lattice";
  Solver solver(scene, make_unsettled_impact(scene));
  const double time_before = solver.state().time;
  for (auto _ : run) solver.cycle(1e9);
  const double particle_steps =
      static_cast<double>(solver.state().size()) * static_cast<double>(solver.state().step);
  run.counters["ns"] = 1e9 * solver.stages().total() / particle_steps;
  run.counters["dt_s"] =
      (solver.state().time - time_before) / static_cast<double>(solver.state().step);
}
BENCHMARK(Scaling)->Arg(500)->Arg(2000)->Arg(8000)->Arg(32000)->Arg(100000)->MinTime(1);

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
