#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/cli/options/options.hpp"
#include "campaign/cli/work.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/manager/throughput.hpp"
#include "campaign/results/finished_run.hpp"
#include "campaign/results/run_records.hpp"
#include "campaign/studies/convergence_study.hpp"
#include "campaign/sweeps/job.hpp"
#include "db/store/lock.hpp"

namespace eerie::cli {

/// What commands that run studies share.
struct StudyArguments {
  std::filesystem::path study, database;
  std::vector<std::filesystem::path> known;  ///< tables of runs that need not be repeated
  double core_hours = 0;                     ///< 0: as much as the study takes
  int workers = 0, threads_per_job = 0;
  bool draw_only = false;
  bool json = false;
};
void add_study(CLI::App& app, StudyArguments& arguments);

/// Runs those of `runs` that the budget pays and that are neither done yet nor known. Throws
/// InputError where it pays for none.
template <class Run>
Tally run_study(const StudyArguments& a, const std::string& name, const std::string& document,
                std::vector<Run> runs, const results::RunRecords& known);

/// A study after its work: what is left of it and all results, known ones included.
template <class Run>
struct StudyWork {
  Tally left;
  std::vector<results::RunWithResult<Run>> results;
  std::optional<job_folder::JobFolder> jobs;  ///< nothing where there is no database
};

/// Runs what run_study() would, unless figures alone are asked for, and collects the results.
template <class Run>
StudyWork<Run> work_on_study(const StudyArguments& a, const std::string& name,
                             const std::string& document, const std::vector<Run>& runs);

/// To read the results from; nothing where there is no database and figures are drawn of known runs
/// alone.
std::optional<db::Connection> results_database(const StudyArguments& a);

/// Of a study that is not finished; the exit code.
int study_exit(const Tally& left);

/// run_study() of runs that are chosen already.
Tally run_scenes(const StudyArguments& a, const std::string& name, const std::string& document,
                 const std::vector<Scene>& scenes, std::size_t known, db::Connection& connection);

template <class Run>
Tally run_study(const StudyArguments& a, const std::string& name, const std::string& document,
                std::vector<Run> runs, const results::RunRecords& known) {
  make_folder_of(a.database);
  const db::Lock lock(a.database);
  db::Connection connection(a.database, db::Access::write);
  if (a.core_hours > 0) {
    const db::Speed speed = db::speed(connection);
    runs = studies::affordable(std::move(runs), a.core_hours,
                               speed.is_measured() ? speed : manager::assumed_speed);
  }
  std::vector<Scene> scenes;
  for (const Run& run : runs)
    if (!known.contains(scene_hash(run.scene))) scenes.push_back(run.scene);
  return run_scenes(a, name, document, scenes, runs.size() - scenes.size(), connection);
}

template <class Run>
StudyWork<Run> work_on_study(const StudyArguments& a, const std::string& name,
                             const std::string& document, const std::vector<Run>& runs) {
  const results::RunRecords known = results::read_run_records(a.known);
  const Tally left = a.draw_only ? Tally{} : run_study(a, name, document, runs, known);
  const std::optional<db::Connection> database = results_database(a);
  if (!database) return {left, results::finished_runs(runs, nullptr, known), {}};
  return {left, results::finished_runs(runs, &*database, known), job_folder::job_folder(*database)};
}

}  // namespace eerie::cli
