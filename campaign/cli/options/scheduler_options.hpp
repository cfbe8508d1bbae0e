#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "campaign/manager/campaign_run.hpp"
#include "campaign/manager/manager.hpp"
#include "campaign/manager/scheduler.hpp"
#include "campaign/process/stop_guard.hpp"
#include "db/store/lock.hpp"

namespace eerie::cli {

/// The options that say where workers run.
struct SchedulerArguments {
  std::string kind = "local";
  std::filesystem::path profile;   ///< the profile of a Slurm cluster
  std::filesystem::path jobs_dir;  ///< empty: beside the database
  double min_free_mb = 200;

  bool is_local() const { return kind == "local"; }
};
void add_scheduler(CLI::App& app, SchedulerArguments& arguments);

/// Throws InputError where the options contradict each other.
void require_consistent(const SchedulerArguments& arguments);

/// A database that this process alone works on, with the folder of its jobs. The constructor makes
/// the folder of the database where it is missing, and blocks stop signals.
struct HeldDatabase {
  HeldDatabase(const std::filesystem::path& database, const SchedulerArguments& scheduler);

  process::StopGuard guard;
  db::Lock lock;
  db::Connection connection;
};

/// Makes the scheduler for a database whose job folder is chosen. `workers` and `threads_per_job`
/// concern local processes.
std::unique_ptr<manager::Scheduler> make_scheduler(const SchedulerArguments& arguments,
                                                   const db::Connection& connection,
                                                   std::size_t workers, int threads_per_job);

manager::ManagerOptions manager_options(const SchedulerArguments& arguments);

/// The workplace of a campaign that runs to its end, with a log beside the database.
manager::Workplace workplace(const SchedulerArguments& arguments, const manager::Share& share);

}  // namespace eerie::cli
