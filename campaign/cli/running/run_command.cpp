#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "campaign/cli/commands.hpp"
#include "campaign/cli/output/results_table.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/cli/output/view_text.hpp"
#include "campaign/cli/output/campaign_watch.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/job_folder/result_file.hpp"
#include "campaign/maps/map.hpp"
#include "campaign/process/signals.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/sweeps/plan.hpp"
#include "db/jobs/control.hpp"
#include "db/jobs/job_settings.hpp"
#include "db/jobs/jobs.hpp"
#include "db/store/lock.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// What --map asks for must be possible before hours of work, not after.
void require_drawable(const std::vector<fs::path>& files, const std::vector<db::NewJob>& jobs) {
  if (files.empty()) return;
  maps::require_map_files(files, "--map");
  if (const std::size_t all = db::count_settings(jobs); all > 1)
    throw InputError(fmt::format(
        "--map {}: the sweep has {} settings, which make maps of their own; leave --map "
        "out, all of them are drawn beside the database",
        files.front().string(), all));
  std::set<std::pair<double, double>> panels;
  for (const db::NewJob& job : jobs) panels.emplace(job.q, job.phi_d_deg);
  if (panels.size() > diagrams::most_panels)
    throw InputError(
        fmt::format("--map {}: the sweep makes {} maps (of q and phi_d), {} are the most in one "
                    "figure; leave --map out, all of them are drawn beside the database",
                    files.front().string(), panels.size(), diagrams::most_panels));
}

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

json report_json(const db::Connection& connection, const RunArguments& a, std::int64_t sweep,
                 const std::string& name, const manager::Tally& t, const std::vector<fs::path>& pictures) {
  json failures = json::array();
  for (const db::FailureGroup& f : db::failures(connection, sweep))
    failures.push_back({{"kind", f.kind},
                        {"jobs", f.jobs},
                        {"hash", f.example_hash},
                        {"message", f.example_message}});
  json paths = json::array();
  for (const fs::path& picture : pictures) paths.push_back(picture.string());
  return {{"sweep", name},
          {"database", a.database.string()},
          {"jobs", {{"total", t.total}, {"done", t.done}, {"failed", t.failed}, {"left", t.left}}},
          {"results", records(db::rows(connection, {.sweeps = {sweep}}))},
          {"failures", std::move(failures)},
          {"pictures", std::move(paths)}};
}

void print_report(const db::Connection& connection, const RunArguments& a, std::int64_t sweep,
                  const manager::Tally& t, const std::vector<fs::path>& pictures) {
  db::ResultFilter filter;
  filter.sweep = sweep;
  fmt::print("\n{}\n", results_table(db::results(connection, filter)));
  fmt::print("{} of {} jobs done", t.done, t.total);
  if (t.failed > 0) fmt::print(", {} failed", t.failed);
  if (t.left > 0) fmt::print(", {} left", t.left);
  fmt::print("\n");
  for (const db::FailureGroup& f : db::failures(connection, sweep))
    fmt::print("failed: {} x {}; for example {}: {}\n", f.jobs, f.kind,
               job_folder::job_folder(connection).of(f.example_hash).path.string(),
               f.example_message);
  if (t.failed > 0) fmt::print("run again with --retry-failed to try the failed jobs once more\n");
  fmt::print("database: {}\n", a.database.string());
  for (const fs::path& picture : pictures) fmt::print("map:      {}\n", picture.string());
}

/// Results that are not to be trusted, in one sentence.
void print_drifts(const db::Connection& connection, std::int64_t sweep) {
  db::ResultFilter filter;
  filter.sweep = sweep;
  const std::vector<db::ResultRow> all = db::results(connection, filter);
  const auto drifting = std::ranges::count_if(all, [](const db::ResultRow& row) {
    return row.result.dL_over_L > job_folder::most_angular_momentum_drift;
  });
  if (drifting > 0)
    print_warnings({fmt::format(
        "{} of {} results changed their angular momentum by more than {:g} %; `eerie query --where "
        "dL_over_L={:g}:` shows them, docs/stability.md what to change",
        drifting, all.size(), 100 * job_folder::most_angular_momentum_drift,
        job_folder::most_angular_momentum_drift)});
}

/// Options of --fidelity auto say nothing without it.
void require_fixed_fidelity(const RunArguments& a) {
  for (const auto& [given, option] :
       {std::pair(a.confidence > 0, "--confidence"), std::pair(a.core_hours > 0, "--budget"),
        std::pair(a.most_seeds > 0, "--most-seeds")})
    if (given)
      throw InputError(
          fmt::format("{} needs --fidelity auto; add that, or leave {} out", option, option));
}

}  // namespace

int run(const RunArguments& a) {
  if (a.changes.fidelity == "auto") return run_auto(a);
  require_fixed_fidelity(a);
  const sweeps::Plan plan = sweeps::load_plan(a.sweep, a.changes.all());
  const std::string& name = plan.sweep.name;
  require_drawable(a.maps, plan.jobs);
  require_consistent(a.engine);
  process::catch_stop_signals();
  process::hold_signals();
  make_folder_of(a.database);
  const db::Lock lock(a.database);
  db::Connection connection(a.database, db::Access::write);
  if (!a.engine.jobs_dir.empty()) job_folder::choose_job_folder(connection, a.engine.jobs_dir);
  const db::AddedSweep added = sweeps::store(connection, plan);
  if (a.retry_failed) db::retry_failed(connection, added.sweep);

  const manager::Tally before = manager::tally(connection, added.sweep);
  if (!a.json) {
    if (before.left == 0)
      fmt::print("{}: nothing left to do\n", name);
    else
      fmt::print("{}: {} jobs, {} new, {} to run\n", name, added.jobs, added.added, before.left);
    std::fflush(stdout);
  }
  if (before.left > 0) print_warnings(sweeps::cautions(plan.scenes));
  if (before.left > 0) {
    CampaignWatch watch(name, a.json);
    manager::work(connection, added.sweep, workplace(a.engine, {a.workers, a.threads_per_job}),
                  watch);
    watch.finish();
  }

  const manager::Tally after = manager::tally(connection, added.sweep);
  std::vector<fs::path> pictures;
  std::string no_pictures;  // why; the outcomes are told all the same
  try {
    pictures = draw(connection, a, added.sweep, name);
  } catch (const EnvironmentError& error) {
    no_pictures = error.what();
  }
  print_drifts(connection, added.sweep);
  if (a.json)
    fmt::print("{}\n", report_json(connection, a, added.sweep, name, after, pictures).dump(1));
  else
    print_report(connection, a, added.sweep, after, pictures);
  if (!no_pictures.empty()) throw EnvironmentError(no_pictures);
  if (after.left > 0 && after.left == after.paused) {
    fmt::print(stderr, "{} jobs are paused; `eerie resume` lets them go on\n", after.paused);
    return static_cast<int>(after.failed > 0 ? ExitCode::job_failed : ExitCode::done);
  }
  if (after.left > 0) {
    fmt::print(
        stderr, "stopped; the same command goes on{}\n",
        a.engine.is_local() ? " from the checkpoints" : "; what is in Slurm's queue stays there");
    return stopped_by_signal;
  }
  return static_cast<int>(after.failed > 0 ? ExitCode::job_failed : ExitCode::done);
}

}  // namespace eerie::cli
