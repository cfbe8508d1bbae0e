#include <spdlog/spdlog.h>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/options/scheduler_options.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/cli/running/notices.hpp"
#include "campaign/cli/running/serve_options.hpp"
#include "campaign/job_folder/log.hpp"
#include "campaign/job_folder/provenance.hpp"
#include "campaign/manager/status_file.hpp"
#include "campaign/process/cores.hpp"
#include "campaign/process/notify.hpp"
#include "campaign/process/signals.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::cli {
namespace {

struct DaemonArguments {
  std::filesystem::path database;
  int workers = 0, threads_per_job = 1;
  SchedulerArguments scheduler;
  bool until_idle = false, serve = false;
  serve::DashboardOptions dashboard;
  std::shared_ptr<NoticeArguments> notices;
};

Answer daemon(const DaemonArguments& a, Output& out) {
  require_consistent(a.scheduler);
  process::catch_stop_signals();
  process::hold_signals();
  make_folder_of_database(a.database);
  constexpr std::uintmax_t least = 1 << 16;  // a database needs some to be opened at all
  if (!manager::wait_for_room(std::filesystem::absolute(a.database).parent_path(), least, complain))
    return {};
  HeldDatabase held(a.database, a.scheduler);
  job_folder::open_campaign_log(
      a.database, out.format == Format::nothing ? spdlog::level::warn : spdlog::level::info);

  const auto threads = static_cast<std::size_t>(a.threads_per_job);
  const std::size_t workers = a.workers > 0
                                  ? static_cast<std::size_t>(a.workers)
                                  : std::max<std::size_t>(1, process::usable_cores() / threads);
  const auto scheduler = make_scheduler(a.scheduler, held.connection, workers, a.threads_per_job);
  manager::ManagerOptions options = manager_options(a.scheduler);
  options.stays = !a.until_idle;
  manager::Manager manager(held.connection, *scheduler, options);

  std::unique_ptr<serve::Dashboard> dashboard;
  if (a.serve) {
    serve::DashboardOptions shown = a.dashboard;
    shown.database = a.database;
    dashboard = std::make_unique<serve::Dashboard>(shown);
    print_address(*dashboard, shown, out);
  }

  const job_folder::Provenance source = job_folder::provenance();
  spdlog::info("event=daemon version={} commit={} pid={} database={} scheduler={} workers={}",
               source.version, source.commit, ::getpid(), a.database.string(), a.scheduler.kind,
               a.scheduler.is_local() ? fmt::format("{}", workers) : "-");
  out.say("working on {}; `eerie submit SWEEP --db {}` gives it work, Ctrl-C ends it\n", a.database,
          shell_word(a.database.string()));
  process::notify_service_manager("READY=1");
  manager::StatusFile status(a.database);
  IdleNews news(*a.notices, a.database);
  manager.run(process::stop_requests, [&](const manager::CampaignView& view) {
    status.show(view);
    news.look(view);
  });
  process::notify_service_manager("STOPPING=1");
  spdlog::info("event=daemon-ends");
  return {};
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
  add_scheduler(app, a->scheduler);
  app.add_flag("--serve", a->serve, "show the database in the browser meanwhile (eerie serve)");
  add_dashboard(app, a->dashboard);
  app.add_flag("--until-idle", a->until_idle, "end when nothing is left to do");
  a->notices = add_notify(app);
  app.add_flag("--quiet")->description("print nothing but complaints");
  return with_news_of_end([a](Output& out) { return daemon(*a, out); }, a->notices, a->database);
}

}  // namespace eerie::cli
