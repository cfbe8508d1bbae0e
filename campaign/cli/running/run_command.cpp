#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/campaign_watch.hpp"
#include "campaign/cli/output/failures.hpp"
#include "campaign/cli/running/notices.hpp"
#include "campaign/cli/running/run_arguments.hpp"
#include "campaign/facts/finding.hpp"
#include "campaign/maps/map.hpp"
#include "campaign/overview/campaign_look.hpp"
#include "campaign/overview/estimate.hpp"
#include "campaign/overview/next_steps.hpp"
#include "campaign/results/results_table.hpp"
#include "campaign/results/view_tables.hpp"
#include "campaign/sweeps/plan.hpp"
#include "db/jobs/control.hpp"
#include "db/jobs/jobs.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

namespace {

/// The two pictures beside the database and those asked for by --map.
std::vector<fs::path> draw(const db::Connection& connection, const RunArguments& a,
                           std::int64_t sweep, const std::string& name) {
  std::vector<fs::path> pictures = maps::draw_sweep_maps(connection, sweep, name);
  if (!a.maps.empty()) {
    db::MapFilter filter;
    filter.sweep = sweep;
    const std::vector<fs::path> written =
        maps::draw_named_maps(connection, {.filter = filter, .files = a.maps});
    pictures.insert(pictures.end(), written.begin(), written.end());
  }
  return pictures;
}

}  // namespace

overview::TypedRun typed(const RunArguments& a) {
  overview::TypedRun run{a.sweep, a.database, a.changes};
  if (!a.scheduler.is_local()) run.options = {"--scheduler", a.scheduler.kind};
  if (!a.scheduler.profile.empty())
    run.options.insert(run.options.end(), {"--profile", a.scheduler.profile.string()});
  for (const CLI::Option* option : a.options_of_auto)
    if (option->count() > 0 && option->get_name() != "--budget")
      run.options.insert(run.options.end(), {option->get_name(), option->as<std::string>()});
  return run;
}

namespace {

Answer report(const db::Connection& connection, const RunArguments& a, const sweeps::Plan& plan,
              const db::AddedSweep& added) {
  const std::int64_t sweep = added.sweep;
  const manager::Tally t = manager::tally(connection, sweep);
  Answer answer;
  conclude(
      answer, t, a.database,
      a.scheduler.is_local() ? " from the checkpoints" : "; what is in Slurm's queue stays there");
  std::vector<fs::path> pictures;
  try {
    pictures = draw(connection, a, sweep, added.label);
  } catch (const EnvironmentError& error) {  // the outcomes are told all the same
    answer.complain("eerie: {}", error.what());
    answer.exit_code = static_cast<int>(ExitCode::environment);
  }
  const std::vector<db::FailureGroup> failures = db::failures(connection, sweep);
  answer.data = {
      {"sweep", added.label},
      {"database", a.database.string()},
      {"jobs", manager::to_json(t)},
      {"results", records(results::plain_table(db::rows(connection, {.sweeps = {sweep}})))},
      {"failures", overview::to_json(failures)},
      {"pictures", names_of(pictures)}};
  db::ResultFilter filter;
  filter.sweep = sweep;
  answer.say("\n");
  const std::vector<db::ResultRow> results = db::results(connection, filter);
  answer.add(results::results_table(results), results::legend_of(connection, results));
  if (const std::string drift = results::drift_warning(connection, results); !drift.empty())
    print_warnings({drift});
  answer.say("\n");
  for (const std::string& sentence : facts::finding(results)) answer.say("{}\n", sentence);
  answer.say("{} of {} jobs done{}{}\n", t.done, t.total,
             t.failed > 0 ? fmt::format(", {} failed", t.failed) : "",
             t.left > 0 ? fmt::format(", {} left", t.left) : "");
  add_failures(answer, failures, job_folder::job_folder(connection));
  answer.say("database: {}\n", a.database);
  for (const fs::path& picture : pictures) answer.say("map:      {}\n", picture);
  const auto steps =
      overview::next_steps(typed(a), plan, t, results, job_folder::job_folder(connection));
  answer.data["next"] = overview::to_json(steps);
  answer.add_text(overview::text_of(steps));
  return answer;
}

void require_fixed_fidelity(const RunArguments& a) {
  for (const CLI::Option* option : a.options_of_auto)
    if (option->count() > 0)
      throw InputError(
          fmt::format("{0} needs --fidelity auto; add that, or leave {0} out", option->get_name()));
}

Answer run(const RunArguments& a, Output& out) {
  if (a.changes.fidelity == "auto") return run_auto(a, out);
  require_fixed_fidelity(a);
  const sweeps::Plan plan = sweeps::load_plan(a.sweep, a.changes);
  if (!a.maps.empty()) {
    maps::require_map_files(a.maps, "--map");
    maps::require_one_figure(plan.jobs, "--map " + a.maps.front().string());
  }
  require_consistent(a.scheduler);
  HeldDatabase held(a.database, a.scheduler);
  CampaignWatch watch(plan.sweep.name, out);
  const db::AddedSweep added = manager::add_when_free(held.connection, watch, [&] {
    const db::AddedSweep sweep = sweeps::store(held.connection, plan);
    if (a.retry_failed) db::retry_failed(held.connection, sweep.sweep);
    return sweep;
  });
  const std::string& name = added.label;
  if (const std::size_t left = manager::tally(held.connection, added.sweep).left; left > 0) {
    out.say("{}\n", overview::cost_sentence(a.database, plan.jobs));
    out.say("{}: {} jobs, {} new, {} to run\n", name, added.jobs, added.added, left);
    if (name != plan.sweep.name)
      out.say("{} is another sweep of this database; --sweep {} means this one\n", plan.sweep.name,
              name);
    print_warnings(sweeps::departures(plan));
    print_warnings(plan.replaced);
    print_warnings(sweeps::cautions(plan.scenes));
    manager::work(held.connection, added.sweep, workplace(a.scheduler, a.share), watch);
  } else {
    out.say("{}: nothing left to do\n", name);
  }
  return report(held.connection, a, plan, added);
}

}  // namespace

Action add_run(CLI::App& app) {
  auto a = std::make_shared<RunArguments>();
  app.add_option("SWEEP", a->sweep, "sweep file")->required();
  add_database(app, a->database);
  add_share(app, a->share.workers, a->share.threads_per_job);
  add_changes(app, a->changes);
  app.add_option("--map", a->maps, "draw the b/a map into this file too (.png, .svg or .pdf)");
  app.add_flag("--retry-failed", a->retry_failed, "run the sweep's failed jobs again");
  a->options_of_auto = {
      app.add_option("--confidence", a->automatic.confidence,
                     "with --fidelity auto: how sure class and b/a < 0.3 must be (default: 0.9)")
          ->check(CLI::Range(0.5, 0.999)),
      app.add_option("--budget", a->core_hours,
                     "with --fidelity auto: core-hours that it may cost (default: no limit)")
          ->check(CLI::Range(1e-6, 1e7)),
      app.add_option(
             "--most-seeds", a->automatic.most_seeds,
             "with --fidelity auto: runs of one impact on the last rung at most (default: 8)")
          ->check(CLI::Range(1, 1000)),
      app.add_option("--finest", a->finest,
                     "with --fidelity auto: the last rung that it climbs (default: fine)")};
  add_scheduler(app, a->scheduler);
  const auto notices = add_notify(app);
  add_formats(app);
  return with_news_of_end([a](Output& out) { return run(*a, out); }, notices, a->database);
}

}  // namespace eerie::cli
