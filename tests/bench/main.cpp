#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/bench/roofline.hpp"

// `eerie_bench [--baseline FILE]`: Google Benchmark, then a roofline table, and ratios to an
// earlier run that was written with --benchmark_out=FILE.

namespace eerie::bench {
namespace {

/// Prints as always, and keeps what it printed.
class Keeper : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.error_occurred) continue;
      seconds[run.benchmark_name()] =
          run.real_accumulated_time / static_cast<double>(run.iterations);
      for (const auto& [name, counter] : run.counters)
        counters[run.benchmark_name()][name] = counter.value;
    }
    ConsoleReporter::ReportRuns(runs);
  }
  std::map<std::string, double> seconds;
  Counters counters;
};

int compare(const std::string& file, const std::map<std::string, double>& seconds) {
  std::ifstream in(file);
  const auto old = nlohmann::json::parse(in, nullptr, false);
  if (old.is_discarded() || !old.contains("benchmarks")) {
    fmt::print(stderr, "eerie_bench: {} is not the JSON of an earlier run (--benchmark_out)\n",
               file);
    return 2;
  }
  const std::map<std::string, double> unit = {{"ns", 1e-9}, {"us", 1e-6}, {"ms", 1e-3}, {"s", 1}};
  fmt::print("\nBefore over now ({}); above 1 is faster now. Machines differ from hour to hour.\n",
             file);
  for (const auto& b : old["benchmarks"]) {
    const auto now = seconds.find(b["name"].get<std::string>());
    if (now == seconds.end() || !b.contains("real_time")) continue;
    const double before = b["real_time"].get<double>() * unit.at(b["time_unit"].get<std::string>());
    fmt::print("{:<50} {:6.2f}\n", now->first, before / now->second);
  }
  return 0;
}

int main(int argc, char** argv) {
  std::string baseline;
  int kept = 0;
  for (int k = 0; k < argc; ++k) {
    if (std::string(argv[k]) == "--baseline" && k + 1 < argc)
      baseline = argv[++k];
    else
      argv[kept++] = argv[k];
  }
  benchmark::Initialize(&kept, argv);
  if (benchmark::ReportUnrecognizedArguments(kept, argv)) return 2;
  Keeper keeper;
  benchmark::RunSpecifiedBenchmarks(&keeper);
  print_roofline(keeper.counters);
  return baseline.empty() ? 0 : compare(baseline, keeper.seconds);
}

}  // namespace
}  // namespace eerie::bench

int main(int argc, char** argv) { return eerie::bench::main(argc, argv); }
