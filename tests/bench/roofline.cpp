#include "tests/bench/roofline.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <vector>

#include "solver/base/simd/rows.hpp"

namespace eerie::bench {
namespace {

/// Multiply-adds on registers, independent of one another.
void PeakArithmetic(benchmark::State& run) {
  constexpr int chains = 12, turns = 1000;
  Pack<float> x[chains];
  for (int k = 0; k < chains; ++k) x[k] = splat(static_cast<float>(k));
  const Pack<float> a = splat(0.999f), b = splat(0.5f);
  for (auto _ : run) {
    for (int t = 0; t < turns; ++t) {
#pragma GCC unroll 12
      for (int k = 0; k < chains; ++k) x[k] = x[k] * a + b;
    }
    for (int k = 0; k < chains; ++k) benchmark::DoNotOptimize(x[k][0]);
  }
  run.counters["vector_ops"] =
      benchmark::Counter(chains * turns, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(PeakArithmetic);

/// Reads and writes in order over the memory of a run: 600 bytes for each of so many particles.
void PeakMemory(benchmark::State& run) {
  std::vector<double> a(static_cast<std::size_t>(run.range(0)) * 600 / sizeof(double), 1.0);
  for (auto _ : run) {
    for (double& x : a) x = x * 0.999 + 0.5;
    benchmark::ClobberMemory();
  }
  run.counters["bytes"] = benchmark::Counter(static_cast<double>(2 * a.size() * sizeof(double)),
                                             benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(PeakMemory)->Arg(10'000)->Arg(100'000);

/// What a stage does for a particle and step with float pair sums, counted by hand in the code
/// (and, for the pair sums, in what the compiler made of it for AVX-512): vector instructions that
/// need one of the two vector ports (arithmetic, shuffles, conversions; divisions and square roots
/// count three), and bytes of state, rates and rows that pass through the cache.
struct Cost {
  const char* stage;
  double vector_ops, bytes;
};
struct Costs {
  int particles_per_target;
  std::vector<Cost> costs;
};
/// A pack of 16 neighbours takes 46 to separate (32 of them turn rows into columns), 31 to weigh,
/// 26 for gradients and weights, 16 for fluxes; a particle 48 to add lanes and 60 to set its rates.
/// Lists hold 4.4 packs on average at 5,000 per target and 5.1 at 50,000, where fewer particles are
/// at the surface.
double pair_ops(double packs) { return packs * (46 + 31 + 26 + 16) + 48 + 60; }
const Costs all_costs[] = {
    {5000, {{"pairs", pair_ops(4.4), 1880}, {"integrate", 60, 640}, {"material", 110, 460}}},
    {50000, {{"pairs", pair_ops(5.1), 1880}, {"integrate", 60, 640}, {"material", 110, 460}}}};

double counter(const Counters& all, const std::string& benchmark, const std::string& name) {
  for (const auto& [full, counters] : all)
    if (full.starts_with(benchmark))
      if (const auto found = counters.find(name); found != counters.end()) return found->second;
  return 0;
}

void print_for(const Counters& counters, int n, const std::vector<Cost>& costs) {
  const std::string impact = fmt::format("ReferenceImpact/float/{}/", n);
  const double ops = counter(counters, "PeakArithmetic", "vector_ops"),
               bytes = counter(counters, fmt::format("PeakMemory/{}", 2 * n), "bytes");
  if (counter(counters, impact, "pairs_ns") == 0 || ops == 0 || bytes == 0) return;
  fmt::print(
      "\nRoofline, {} per target, one thread; peaks seen in this run: {:.2f} vector operations "
      "per ns, {:.1f} bytes per ns\n",
      n, ops / 1e9, bytes / 1e9);
  fmt::print("{:<10} {:>6} {:>12} {:>7} {:>8} {:>7}\n", "stage", "ns", "vector ops", "of peak",
             "bytes", "of peak");
  for (const Cost& c : costs) {
    const double ns = counter(counters, impact, std::string(c.stage) + "_ns");
    fmt::print("{:<10} {:>6.0f} {:>12.0f} {:>6.0f}% {:>8.0f} {:>6.0f}%\n", c.stage, ns,
               c.vector_ops, 100 * c.vector_ops / ns / (ops / 1e9), c.bytes,
               100 * c.bytes / ns / (bytes / 1e9));
  }
}

}  // namespace

void print_roofline(const Counters& counters) {
  for (const Costs& c : all_costs) print_for(counters, c.particles_per_target, c.costs);
}

}  // namespace eerie::bench
