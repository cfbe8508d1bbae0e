#include "campaign/studies/study_run.hpp"

#include <fmt/format.h>

#include "campaign/process/signals.hpp"
#include "campaign/process/stop_guard.hpp"
#include "db/jobs/jobs.hpp"

namespace eerie::studies {

manager::Tally run_scenes(const StudyPlan& plan, const std::vector<Scene>& scenes,
                          std::size_t known, db::Connection& connection,
                          const manager::Workplace& workplace, StudyObserver& observer) {
  if (scenes.empty() && known > 0) return {};
  if (scenes.empty())
    throw InputError(
        fmt::format("--budget = {:g}: does not pay for the first run; raise it", plan.core_hours));
  process::catch_stop_signals();
  process::hold_signals();
  const process::StopGuard guard;
  const db::AddedSweep added = manager::add_when_free(connection, observer, [&] {
    return db::add_sweep(connection, plan.name, plan.document, sweeps::jobs_in_order(scenes));
  });
  const std::size_t left = manager::tally(connection, added.sweep).left;
  observer.begins(scenes.size() + known, known, left);
  if (left > 0) manager::work(connection, added.sweep, workplace, observer);
  return manager::tally(connection, added.sweep);
}

std::optional<db::Connection> results_database(const StudyPlan& plan) {
  if (plan.draw_only && !plan.known.empty() && !std::filesystem::exists(plan.database)) return {};
  return std::optional<db::Connection>(std::in_place, plan.database, db::Access::read);
}

}  // namespace eerie::studies
