#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "campaign/manager/campaign_run.hpp"
#include "campaign/manager/manager.hpp"
#include "campaign/manager/scheduler.hpp"
#include "db/store/lock.hpp"

namespace eerie::cli {

/// Where workers run, as the command line says it.
struct SchedulerArguments {
  std::string kind = "local";
  std::filesystem::path profile;   ///< of Slurm
  std::filesystem::path jobs_dir;  ///< empty: beside the database
  double min_free_mb = 200;

  bool is_local() const { return kind == "local"; }
};
void add_scheduler(CLI::App& app, SchedulerArguments& arguments);

/// Throws InputError where the options do not fit together.
void require_consistent(const SchedulerArguments& arguments);

/// A database that this process alone works on, with the folder of its jobs. Its own folder is made
/// where there is none, and stop signals are held.
struct HeldDatabase {
  HeldDatabase(const std::filesystem::path& database, const SchedulerArguments& scheduler);

  db::Lock lock;
  db::Connection connection;
};

/// The scheduler for a database whose job folder is chosen. `workers` and `threads_per_job` are of
/// local processes.
std::unique_ptr<manager::Scheduler> make_scheduler(const SchedulerArguments& arguments,
                                                   const db::Connection& connection,
                                                   std::size_t workers, int threads_per_job);

manager::ManagerOptions manager_options(const SchedulerArguments& arguments);

/// The same for campaigns that run to their end, with a log beside the database.
manager::Workplace workplace(const SchedulerArguments& arguments, const manager::Share& share);

/// Logs to "<database>.log", three files of 10 MB in turn, and to standard error where wanted.
void open_manager_log(const std::filesystem::path& database, bool to_stderr);

}  // namespace eerie::cli
