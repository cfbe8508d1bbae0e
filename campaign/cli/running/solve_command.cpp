#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "campaign/cli/commands.hpp"
#include "campaign/cli/output/outcome_text.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/job_folder/log.hpp"
#include "campaign/job_folder/result_file.hpp"
#include "campaign/job_folder/worker_lock.hpp"
#include "campaign/manager/local_processes.hpp"
#include "campaign/process/signals.hpp"
#include "campaign/sweeps/scene_field.hpp"
#include "campaign/text/json_file.hpp"
#include "campaign/worker/worker.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/simd.hpp"
#include "solver/scene/guards.hpp"
#include "solver/scene/validate.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

Scene load_scene(const SolveArguments& a) {
  const std::string where = a.scene.string();
  json document = sweeps::with_integers(text::load_json(a.scene));
  require_valid(scene_schema(), document, where);
  sweeps::apply_overrides(document, a.changes.all());
  return parse_scene(document, where);
}

/// Prints where the run is: often on a terminal, else every ten seconds.
class StepLine {
 public:
  void operator()(const run::Progress& p) {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + (terminal_ ? std::chrono::milliseconds(500) : std::chrono::seconds(10));
    fmt::print(stderr, "{}{:.6g} of {:.6g} s, step {}, dt {:.3g} s{}", terminal_ ? "\r\033[K" : "",
               p.time, p.end_time, p.step, p.dt, terminal_ ? "" : "\n");
    std::fflush(stderr);
  }
  void finish() const {
    if (terminal_) fmt::print(stderr, "\r\033[K");
  }

 private:
  bool terminal_ = ::isatty(STDERR_FILENO) != 0;
  std::chrono::steady_clock::time_point next_{};
};

double particle_steps_here(const run::RunSummary& s) {
  return s.steps_here * static_cast<double>(s.last.state.size());
}

/// Of the stepping alone: the making of the bodies happens once, however long the run.
double rate_per_core(const run::RunSummary& s) {
  return s.stages.total() > 0 ? particle_steps_here(s) / (s.stages.total() * s.threads) : 0;
}

void print_cost(const run::RunSummary& s) {
  fmt::print("{} steps to {:.6g} s, {} particle-steps; {:.0f} steps here in {} on {} thread{}\n",
             s.progress.step, s.progress.time, magnitude(s.progress.particle_steps), s.steps_here,
             duration(s.progress.wall_s), s.threads, s.threads == 1 ? "" : "s");
  fmt::print("{} particle-steps per second and core ({})\n\n", magnitude(rate_per_core(s)),
             vector_variant);
  std::vector<std::vector<std::string>> rows = {{"stage", "s", "%"}};
  const double wall = std::max(s.progress.wall_s, s.stages.total());
  const auto add = [&](std::string_view name, double seconds) {
    rows.push_back({std::string(name), fmt::format("{:.2f}", seconds),
                    fmt::format("{:.1f}", wall > 0 ? 100 * seconds / wall : 0)});
  };
  for (std::size_t i = 0; i < stage_count; ++i) add(stage_names[i], s.stages.seconds[i]);
  add("making the bodies", wall - s.stages.total());
  fmt::print("{}\n", text_table(rows));
}

}  // namespace

int solve(const SolveArguments& a) {
  const Scene scene = load_scene(a);
  print_warnings(warnings(scene));
  process::catch_stop_signals();
  std::error_code problem;
  fs::create_directories(a.directory, problem);
  if (problem)
    throw EnvironmentError(fmt::format("cannot make the folder {}: {}; give another to --out",
                                       a.directory.string(), problem.message()));
  const job_folder::JobDirectory directory{a.directory};
  const job_folder::WorkerLock lock(directory);
  install_text(directory.scene(), to_json(scene).dump(1) + "\n");
  job_folder::open_log(directory);
  const int threads = a.threads > 0 ? a.threads : static_cast<int>(manager::usable_cores());
  StepLine line;
  const worker::Computed computed =
      worker::compute(scene, a.directory, threads, a.max_steps, std::ref(line));
  line.finish();
  const run::RunSummary& summary = computed.summary;
  const bool finished = summary.end == run::RunEnd::finished;
  for (const std::string& warning : job_folder::run_warnings(scene, summary))
    spdlog::warn("{}", warning);
  print_warnings(job_folder::run_warnings(scene, summary));
  if (finished)
    install_text(directory.result(),
                 job_folder::result_json(scene, summary, computed.analysis).dump(1) + "\n");
  if (a.json) {
    json report = job_folder::result_json(scene, summary, computed.analysis);
    report["finished"] = finished;
    report["run"]["particle_steps_per_core_second"] = rate_per_core(summary);
    fmt::print("{}\n", report.dump(1));
  } else {
    print_cost(summary);
    fmt::print("{}", outcome_text(computed.analysis));
  }
  if (summary.end == run::RunEnd::step_limit && !a.json)
    fmt::print("\nstopped after --max-steps {}; the same command goes on from there\n",
               a.max_steps);
  if (summary.end == run::RunEnd::stopped) {
    fmt::print(stderr, "stopped; the same command goes on from the checkpoint\n");
    return 130;
  }
  return static_cast<int>(ExitCode::done);
}

}  // namespace eerie::cli
