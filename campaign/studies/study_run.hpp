#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job_folder/job_directory.hpp"
#include "campaign/manager/campaign_run.hpp"
#include "campaign/results/finished_run.hpp"
#include "campaign/results/run_records.hpp"
#include "db/store/lock.hpp"
#include "solver/base/error.hpp"

namespace eerie::studies {

/// The plan of a study: what to run, and where the results are.
struct StudyPlan {
  std::string name, document;  ///< of the sweep that the database gets
  std::filesystem::path database;
  std::vector<std::filesystem::path> known;  ///< tables of runs that need no repetition
  double core_hours = 0;                     ///< 0: no limit
  bool draw_only = false;                    ///< runs nothing
};

class StudyObserver : public virtual manager::CampaignObserver {
 public:
  /// `runs` are within the budget; of these `known` are known and `left` remain to run.
  virtual void begins(std::size_t runs, std::size_t known, std::size_t left) = 0;
};

/// Runs these scenes; `known` further ones need no run. Throws InputError where there are none of
/// either.
manager::Tally run_scenes(const StudyPlan& plan, const std::vector<Scene>& scenes,
                          std::size_t known, db::Connection& connection,
                          const manager::Workplace& workplace, StudyObserver& observer);

/// Runs those of `runs` that the budget allows and that are neither done nor known. The folder of
/// the database must exist. Throws InputError where the budget allows none.
template <class Run>
manager::Tally run_study(const StudyPlan& plan, std::vector<Run> runs,
                         const results::RunRecords& known, const manager::Workplace& workplace,
                         StudyObserver& observer) {
  const db::Lock lock(plan.database);
  db::Connection connection(plan.database, db::Access::write);
  if (plan.core_hours > 0)
    runs = manager::affordable(std::move(runs), plan.core_hours, manager::known_speed(connection));
  std::vector<Scene> scenes;
  for (const Run& run : runs)
    if (!known.contains(scene_hash(run.scene))) scenes.push_back(run.scene);
  return run_scenes(plan, scenes, runs.size() - scenes.size(), connection, workplace, observer);
}

/// The database of the results. Nothing where there is none, so that figures show known runs alone.
std::optional<db::Connection> results_database(const StudyPlan& plan);

/// A study after its runs: what is left of it, and all results, known ones included.
template <class Run>
struct StudyWork {
  manager::Tally left;
  std::vector<results::RunWithResult<Run>> results;
  std::optional<job_folder::JobFolder> jobs;  ///< nothing where there is no database
};

/// Calls run_study(), unless only figures are wanted, and collects the results.
template <class Run>
StudyWork<Run> work_on_study(const StudyPlan& plan, const std::vector<Run>& runs,
                             const manager::Workplace& workplace, StudyObserver& observer) {
  const results::RunRecords known = results::read_run_records(plan.known);
  const manager::Tally left =
      plan.draw_only ? manager::Tally{} : run_study(plan, runs, known, workplace, observer);
  const std::optional<db::Connection> database = results_database(plan);
  if (!database) return {left, results::finished_runs(runs, nullptr, known), {}};
  return {left, results::finished_runs(runs, &*database, known), job_folder::job_folder(*database)};
}

}  // namespace eerie::studies
