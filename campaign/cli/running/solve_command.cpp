#include <spdlog/spdlog.h>

#include <algorithm>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/outcome_tables.hpp"
#include "campaign/cli/output/status_line.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/job_folder/log.hpp"
#include "campaign/job_folder/result_file.hpp"
#include "campaign/job_folder/worker_lock.hpp"
#include "campaign/process/cores.hpp"
#include "campaign/process/signals.hpp"
#include "campaign/sweeps/beginnings.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "campaign/text/given_folder.hpp"
#include "campaign/text/json_file.hpp"
#include "campaign/worker/solve_folder.hpp"
#include "campaign/worker/worker.hpp"
#include "solver/base/file.hpp"
#include "solver/base/simd/pack.hpp"
#include "solver/scene/guards.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct SolveArguments {
  fs::path scene, directory;
  long max_steps = 0;  ///< 0: until the end time
  int threads = 0;     ///< 0: all cores
  SceneChanges changes;
};

/// Where the run is, in a line for people. Runs that end once settled mostly end long before the
/// latest time.
std::string text_of(const run::Progress& p, double expected_end_s, Eta& eta) {
  const double end = p.time < expected_end_s ? expected_end_s : p.end_time;
  const std::string dt = p.dt > 0 ? fmt::format(", dt {:.3g} s", p.dt) : "";
  return fmt::format("{:.6g} of {}{:.6g} s, step {}{}{}", p.time, end < p.end_time ? "about " : "",
                     end, p.step, dt, eta.text(p.time / end));
}

void add_cost(Answer& answer, const run::RunSummary& s) {
  answer.say("{} steps to {:.6g} s, {} particle-steps; {:.0f} steps here in {} on {}\n",
             s.progress.step, s.progress.time, magnitude(s.progress.particle_steps), s.steps_here,
             duration(s.progress.wall_s), count_of(static_cast<std::size_t>(s.threads), "thread"));
  answer.say("{} particle-steps per second and core ({})\n\n",
             magnitude(s.particle_steps_per_core_second()), vector_variant);
  Table table{{shown("stage"), shown("s", "{:.2f}"), shown("%", "{:.1f}")}, {}};
  const double wall = std::max(s.progress.wall_s, s.stages.total());
  const auto add = [&](std::string_view name, double seconds) {
    table.rows.push_back({name, seconds, wall > 0 ? 100 * seconds / wall : 0.0});
  };
  for (std::size_t i = 0; i < stage_count; ++i) add(stage_names[i], s.stages.seconds[i]);
  add("making the bodies", wall - s.stages.total());
  answer.add(std::move(table));
  answer.say("\n");
}

/// The result that an earlier call left.
Answer answer_of(const job_folder::JobDirectory& directory) {
  Answer answer;
  answer.data = text::load_json(directory.result());
  answer.data["finished"] = true;
  const json& run = answer.data.at("run");
  answer.say("{}: this scene is done, at {:.6g} s ({}); nothing left to do\n", directory.path,
             run.at("end_time_s").get<double>(), run.value("end_reason", "end-time"));
  return answer;
}

Answer report(const Scene& scene, const SolveArguments& a, const worker::Computed& computed) {
  const run::RunSummary& summary = computed.summary;
  const bool finished = summary.end == run::RunEnd::finished;
  for (const std::string& warning : job_folder::run_warnings(scene, summary))
    spdlog::warn("{}", warning);
  print_warnings(job_folder::run_warnings(scene, summary));
  Answer answer;
  answer.data = job_folder::result_json(scene, summary, computed.analysis);
  if (finished)
    install_text(job_folder::JobDirectory{a.directory}.result(), answer.data.dump(1) + "\n");
  answer.data["finished"] = finished;
  answer.data["run"]["particle_steps_per_core_second"] = summary.particle_steps_per_core_second();
  add_cost(answer, summary);
  add_outcome(answer, answer.data.at("analysis"));
  if (summary.end == run::RunEnd::step_limit)
    answer.say("\nstopped after --max-steps {}; the same command goes on from there\n",
               a.max_steps);
  if (summary.end == run::RunEnd::stopped) {
    answer.complain("stopped; the same command goes on from the checkpoint");
    answer.exit_code = stopped_by_signal;
  }
  return answer;
}

Answer solve(const SolveArguments& a, Format format) {
  const auto [scene, replaced] = sweeps::load_scene(a.scene, a.changes);
  print_warnings(replaced);
  print_warnings(warnings(scene));
  process::catch_stop_signals();
  const job_folder::JobDirectory directory{a.directory};
  worker::require_own_folder(directory, scene);
  // Work that was begun holds its bodies already.
  if (!fs::exists(a.directory)) sweeps::require_beginnings({&scene, 1});
  text::make_given_folder(a.directory);
  const job_folder::WorkerLock lock(directory);
  worker::require_own_folder(directory, scene);  // as whoever held the lock left it
  if (worker::is_done(directory, scene, complain)) return answer_of(directory);
  worker::require_usable_checkpoint(directory, scene, complain);
  worker::keep_scene(directory, scene, a.scene);
  job_folder::open_log(directory);
  const int threads = a.threads > 0 ? a.threads : process::usable_threads();
  StatusLine line(format);
  Eta eta;
  const double expected_end_s = sweeps::expected_end_s(scene);
  const worker::Computed computed =
      worker::compute(scene, a.directory, threads, a.max_steps, [&](const run::Progress& p) {
        line.show([&](std::size_t, bool) { return text_of(p, expected_end_s, eta); });
      });
  line.finish();
  return report(scene, a, computed);
}

}  // namespace

Action add_solve(CLI::App& app) {
  auto a = std::make_shared<SolveArguments>();
  app.add_option("SCENE", a->scene, "scene file")->required();
  app.add_option("--out", a->directory, "folder for snapshots, history and result")->required();
  app.add_option("--max-steps", a->max_steps, "stop after so many steps (default: at the end time)")
      ->check(CLI::Range(1L, 1'000'000'000'000L));
  app.add_option("--threads", a->threads, "threads (default: OMP_NUM_THREADS, else all cores)")
      ->check(CLI::Range(1, most_threads));
  add_changes(app, a->changes);
  add_formats(app);
  return [a](Output& out) { return solve(*a, out.format); };
}

}  // namespace eerie::cli
