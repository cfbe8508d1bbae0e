#include "campaign/cli/options/scheduler_options.hpp"

#include <fmt/format.h>

#include "campaign/cli/output/complain.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/job_folder/log.hpp"
#include "campaign/manager/local_processes.hpp"
#include "campaign/manager/waiting/patience.hpp"
#include "campaign/process/signals.hpp"
#include "campaign/slurm/profile.hpp"
#include "campaign/slurm/slurm_scheduler.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

void add_scheduler(CLI::App& app, SchedulerArguments& a) {
  app.add_option("--scheduler", a.kind, "where workers run: local or slurm")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  app.add_option("--profile", a.profile, "JSON file with Slurm's partition, account, time...");
  app.add_option("--jobs-dir", a.jobs_dir,
                 "folder of the job directories (default: FILE.jobs beside the database)");
  app.add_option("--min-free-mb", a.min_free_mb,
                 "start no job with less free space than this on a disk, MB")
      ->check(CLI::Range(0.0, 1e9))
      ->capture_default_str();
}

void require_consistent(const SchedulerArguments& a) {
  if (!a.profile.empty() && !a.is_local())
    slurm::load_slurm_profile(a.profile);  // tell mistakes now
  if (a.is_local() && !a.profile.empty())
    throw InputError(
        fmt::format("--profile {}: is for Slurm; add --scheduler slurm", a.profile.string()));
  try {
    text::require_folder_above(a.jobs_dir);
  } catch (const InputError& error) {
    throw InputError(fmt::format("--jobs-dir {}", error.what()));
  }
}

HeldDatabase::HeldDatabase(const fs::path& database, const SchedulerArguments& scheduler)
    : lock((process::catch_stop_signals(), process::hold_signals(),
            make_folder_of_database(database), database)),
      connection(database, db::Access::write) {
  if (scheduler.jobs_dir.empty()) return;
  manager::when_free(
      connection, [&] { job_folder::choose_job_folder(connection, scheduler.jobs_dir); }, complain);
}

std::unique_ptr<manager::Scheduler> make_scheduler(const SchedulerArguments& a,
                                                   const db::Connection& connection,
                                                   std::size_t workers, int threads_per_job) {
  if (a.is_local()) return std::make_unique<manager::LocalProcesses>(workers, threads_per_job);
  return std::make_unique<slurm::SlurmScheduler>(
      a.profile.empty() ? slurm::SlurmProfile{} : slurm::load_slurm_profile(a.profile),
      fs::absolute(job_folder::job_folder(connection).root));
}

manager::ManagerOptions manager_options(const SchedulerArguments& a) {
  manager::ManagerOptions options;
  options.leaves_workers = !a.is_local();
  options.least_free_bytes = static_cast<std::uintmax_t>(a.min_free_mb * 1e6);
  return options;
}

manager::Workplace workplace(const SchedulerArguments& a, const manager::Share& share) {
  return {[a](const db::Connection& connection, const manager::Split& split) {
            job_folder::open_campaign_log(connection.path(), spdlog::level::off);
            return make_scheduler(a, connection, split.jobs, split.threads);
          },
          a.is_local(), share, manager_options(a)};
}

}  // namespace eerie::cli
