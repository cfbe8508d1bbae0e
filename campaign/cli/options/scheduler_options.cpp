#include "campaign/cli/options/scheduler_options.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include "campaign/cli/output/complain.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/job_folder/log.hpp"
#include "campaign/manager/local_processes.hpp"
#include "campaign/manager/waiting/patience.hpp"
#include "campaign/process/signals.hpp"
#include "campaign/slurm/profile.hpp"
#include "campaign/slurm/slurm_scheduler.hpp"
#include "db/store/place.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

void add_engine(CLI::App& app, EngineArguments& a) {
  app.add_option("--scheduler", a.scheduler, "where workers run: local or slurm")
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

void require_consistent(const EngineArguments& a) {
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

HeldDatabase::HeldDatabase(const fs::path& database, const EngineArguments& engine)
    : lock((process::catch_stop_signals(), process::hold_signals(),
            make_folder_of_database(database), database)),
      connection(database, db::Access::write) {
  if (engine.jobs_dir.empty()) return;
  manager::when_free(
      connection, [&] { job_folder::choose_job_folder(connection, engine.jobs_dir); }, complain);
}

std::unique_ptr<manager::Scheduler> make_scheduler(const EngineArguments& a,
                                                   const db::Connection& connection,
                                                   std::size_t workers, int threads_per_job) {
  if (a.is_local()) return std::make_unique<manager::LocalProcesses>(workers, threads_per_job);
  return std::make_unique<slurm::SlurmScheduler>(
      a.profile.empty() ? slurm::SlurmProfile{} : slurm::load_slurm_profile(a.profile),
      fs::absolute(job_folder::job_folder(connection).root));
}

manager::ManagerOptions manager_options(const EngineArguments& a) {
  manager::ManagerOptions options;
  options.leaves_workers = !a.is_local();
  options.least_free_bytes = static_cast<std::uintmax_t>(a.min_free_mb * 1e6);
  return options;
}

manager::Workplace workplace(const EngineArguments& a, const manager::Share& share) {
  return {[a](const db::Connection& connection, const manager::Split& split) {
            open_manager_log(connection.path(), false);
            return make_scheduler(a, connection, split.jobs, split.threads);
          },
          a.is_local(), share, manager_options(a)};
}

void open_manager_log(const std::filesystem::path& database, bool to_stderr) {
  constexpr std::size_t bytes = 10'000'000, files = 3;
  try {
    std::vector<spdlog::sink_ptr> sinks = {std::make_shared<spdlog::sinks::rotating_file_sink_mt>(
        db::resolved(database).string() + ".log", bytes, files)};
    if (to_stderr) sinks.push_back(std::make_shared<spdlog::sinks::stderr_sink_mt>());
    auto log = std::make_shared<spdlog::logger>("manager", sinks.begin(), sinks.end());
    log->set_formatter(job_folder::log_formatter());
    log->flush_on(spdlog::level::info);
    // A full disk must not fill standard error as well.
    log->set_error_handler([](const std::string&) {});
    spdlog::set_default_logger(std::move(log));
  } catch (const spdlog::spdlog_ex& error) {
    throw EnvironmentError(error.what());
  }
}

}  // namespace eerie::cli
