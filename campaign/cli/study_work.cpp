#include "campaign/cli/study_work.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "campaign/process/signals.hpp"
#include "db/jobs/jobs.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {

void add_study(CLI::App& app, StudyArguments& a) {
  app.add_option("STUDY", a.study, "study file")->required();
  add_database(app, a.database);
  app.add_option("--known", a.known,
                 "runs.csv that this command wrote before or elsewhere: what stands in it is not "
                 "run again; may be given several times")
      ->allow_extra_args(false)
      ->check(CLI::ExistingFile);
  app.add_option("--budget", a.core_hours,
                 "core-hours that the study may cost, finished runs included (default: no limit)")
      ->check(CLI::Range(0.001, 1e7));
  add_share(app, a.workers, a.threads_per_job);
  app.add_flag("--draw-only", a.draw_only, "run nothing: figures and tables of what is there");
  add_json(app, a.json);
}

Tally run_scenes(const StudyArguments& a, const std::string& name, const std::string& document,
                 const std::vector<Scene>& scenes, std::size_t known, db::Connection& connection) {
  if (scenes.empty() && known > 0) return {};
  if (scenes.empty())
    throw InputError(
        fmt::format("--budget = {:g}: does not pay for the first run; raise it", a.core_hours));
  process::catch_stop_signals();
  process::hold_signals();
  const db::AddedSweep added =
      db::add_sweep(connection, name, document, sweeps::jobs_in_order(scenes));
  const std::size_t left = tally(connection, added.sweep).left;
  if (!a.json) {
    fmt::print("{}: {} runs within the budget, {}{} to run\n", name, scenes.size() + known,
               known > 0 ? fmt::format("{} known, ", known) : "", left);
    std::fflush(stdout);
  }
  if (left > 0) work(connection, {a.workers, a.threads_per_job, a.json}, added.sweep);
  return tally(connection, added.sweep);
}

std::optional<db::Connection> results_database(const StudyArguments& a) {
  if (a.draw_only && !a.known.empty() && !std::filesystem::exists(a.database)) return {};
  return std::optional<db::Connection>(std::in_place, a.database, db::Access::read);
}

int study_exit(const Tally& left) {
  if (left.left > 0) {
    fmt::print(stderr, "stopped; the same command goes on from the checkpoints\n");
    return stopped_by_signal;
  }
  return static_cast<int>(left.failed > 0 ? ExitCode::job_failed : ExitCode::done);
}

}  // namespace eerie::cli
