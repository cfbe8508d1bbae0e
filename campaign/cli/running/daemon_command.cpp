#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cstdio>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/options/scheduler_options.hpp"
#include "campaign/cli/output/progress_line.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/job_folder/provenance.hpp"
#include "campaign/manager/local_processes.hpp"
#include "campaign/manager/status_file.hpp"
#include "campaign/process/notify.hpp"
#include "campaign/process/signals.hpp"
#include "db/store/lock.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace {

struct DaemonArguments {
  std::filesystem::path database;
  int workers = 0, threads_per_job = 1;
  EngineArguments engine;
  bool until_idle = false;
};

/// A database needs some room to be opened at all. False: a stop was asked for first.
bool wait_for_room(const std::filesystem::path& folder) {
  constexpr std::uintmax_t least = 1 << 16;
  manager::DiskGuard guard({folder}, least);
  for (bool told = false; process::stop_requests() == 0; told = true) {
    const auto complaint = guard.complaint(manager::DiskGuard::Clock::now());
    if (!complaint) return true;
    if (!told) fmt::print(stderr, "waiting: {}\n", *complaint);
    process::wait_for_signal(std::chrono::seconds(1));
  }
  return false;
}

int daemon(const DaemonArguments& a) {
  require_consistent(a.engine);
  process::catch_stop_signals();
  process::hold_signals();
  make_folder_of(a.database);
  if (!wait_for_room(std::filesystem::absolute(a.database).parent_path()))
    return static_cast<int>(ExitCode::done);
  const db::Lock lock(a.database);
  db::Connection connection(a.database, db::Access::write);
  if (!a.engine.jobs_dir.empty()) job_folder::choose_job_folder(connection, a.engine.jobs_dir);
  open_manager_log(a.database, true);

  const auto threads = static_cast<std::size_t>(a.threads_per_job);
  const std::size_t workers = a.workers > 0
                                  ? static_cast<std::size_t>(a.workers)
                                  : std::max<std::size_t>(1, manager::usable_cores() / threads);
  const auto scheduler = make_scheduler(a.engine, connection, workers, a.threads_per_job);
  manager::ManagerOptions options = manager_options(a.engine);
  options.stays = !a.until_idle;
  manager::Manager manager(connection, *scheduler, options);

  const job_folder::Provenance source = job_folder::provenance();
  spdlog::info("event=daemon version={} commit={} pid={} database={} scheduler={} workers={}",
               source.version, source.commit, ::getpid(), a.database.string(), a.engine.scheduler,
               a.engine.is_local() ? fmt::format("{}", workers) : "-");
  fmt::print("working on {}; `eerie submit SWEEP --db {}` gives it work, Ctrl-C ends it\n",
             a.database.string(), a.database.string());
  std::fflush(stdout);
  process::notify_service_manager("READY=1");
  manager::StatusFile status(a.database);
  manager.run(process::stop_requests,
              [&](const manager::CampaignView& view) { status.show(view); });
  process::notify_service_manager("STOPPING=1");
  spdlog::info("event=daemon-ends");
  return static_cast<int>(ExitCode::done);
}

}  // namespace

Action add_daemon(CLI::App& app) {
  auto a = std::make_shared<DaemonArguments>();
  add_database(app, a->database);
  app.add_option("--workers", a->workers, "jobs at a time (default: as many as there are cores)")
      ->check(CLI::Range(1, most_threads));
  app.add_option("--threads-per-job", a->threads_per_job, "threads of each job")
      ->check(CLI::Range(1, most_threads))
      ->capture_default_str();
  add_engine(app, a->engine);
  app.add_flag("--until-idle", a->until_idle, "end when nothing is left to do");
  return [a] { return daemon(*a); };
}

}  // namespace eerie::cli
