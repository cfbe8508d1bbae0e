#include "campaign/cli/options/study_options.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "solver/base/error.hpp"

namespace eerie::cli {

void add_study(CLI::App& app, StudyArguments& a) {
  app.add_option("STUDY", a.study, "study file")->required();
  add_database(app, a.plan.database);
  app.add_option("--known", a.plan.known,
                 "runs.csv that this command wrote before or elsewhere: what stands in it is not "
                 "run again; may be given several times")
      ->allow_extra_args(false)
      ->check(CLI::ExistingFile);
  app.add_option("--budget", a.plan.core_hours,
                 "core-hours that the study may cost, finished runs included (default: no limit)")
      ->check(CLI::Range(0.001, 1e7));
  add_share(app, a.share.workers, a.share.threads_per_job);
  app.add_flag("--draw-only", a.plan.draw_only, "run nothing: figures and tables of what is there");
  add_json(app, a.json);
}

int study_exit(const manager::Tally& left) {
  if (left.left > 0) {
    fmt::print(stderr, "stopped; the same command goes on from the checkpoints\n");
    return stopped_by_signal;
  }
  return static_cast<int>(left.failed > 0 ? ExitCode::job_failed : ExitCode::done);
}

}  // namespace eerie::cli
