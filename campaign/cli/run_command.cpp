#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "campaign/cli/commands.hpp"
#include "campaign/cli/progress_line.hpp"
#include "campaign/cli/result_columns.hpp"
#include "campaign/cli/text_table.hpp"
#include "campaign/job.hpp"
#include "campaign/local_processes.hpp"
#include "campaign/map.hpp"
#include "campaign/run_loop.hpp"
#include "campaign/signals.hpp"
#include "campaign/split.hpp"
#include "db/lock.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr int stopped_by_signal = 130;  // 128 + SIGINT, as shells expect

void make_folder_of(const fs::path& file) {
  if (!file.has_parent_path()) return;
  std::error_code problem;
  fs::create_directories(file.parent_path(), problem);
  if (problem)
    throw EnvironmentError(fmt::format("cannot make the folder {}: {}; give another file to --db",
                                       file.parent_path().string(), problem.message()));
}

/// What --map asks for must be possible before hours of work, not after.
void require_drawable(const std::vector<fs::path>& files, const std::vector<db::NewJob>& jobs) {
  if (files.empty()) return;
  for (const fs::path& file : files) {
    const std::string kind = file.extension().string();
    if (kind != ".png" && kind != ".svg" && kind != ".pdf")
      throw InputError(fmt::format("--map {}: must end in .png, .svg or .pdf; for example map.png",
                                   file.string()));
  }
  std::set<std::tuple<double, double, std::int64_t>> maps;
  for (const db::NewJob& job : jobs) maps.emplace(job.q, job.phi_d_deg, job.particles_per_target);
  if (maps.size() > 1)
    throw InputError(
        fmt::format("--map {}: the sweep makes {} maps (of q, phi_d and particles per target); "
                    "leave --map out, all "
                    "of them are drawn beside the database",
                    files.front().string(), maps.size()));
}

/// Core-seconds of work from which on measuring splits pays, and what a measurement takes.
constexpr double worth_measuring_s = 120, assumed_speed = 2e6;
constexpr std::chrono::duration<double> measurement{0.4};

std::string text(const Split& split) {
  return fmt::format("{} job{} x {} thread{}", split.jobs, split.jobs == 1 ? "" : "s",
                     split.threads, split.threads == 1 ? "" : "s");
}

/// As the user says, else as measured on the longest job; without a measurement, many narrow jobs.
Split choose_split(const RunArguments& a, const std::vector<db::Job>& pending,
                   const db::Connection& connection) {
  const std::size_t cores = usable_cores();
  const auto threads = static_cast<std::size_t>(std::max(1, a.threads_per_job));
  if (a.workers > 0) return {static_cast<std::size_t>(a.workers), static_cast<int>(threads), 0};
  if (a.threads_per_job > 0)
    return {std::max<std::size_t>(1, cores / threads), a.threads_per_job, 0};
  double particle_steps = 0;
  for (const db::Job& job : pending) particle_steps += job.expected_particle_steps;
  const std::vector<Split> possible = possible_splits(cores, pending.size());
  if (possible.size() == 1 || particle_steps / assumed_speed < worth_measuring_s)
    return possible.front();
  const auto longest = std::ranges::max_element(pending, {}, &db::Job::expected_particle_steps);
  const Scene scene = parse_scene(json::parse(db::scene(connection, longest->id)));
  const std::vector<Split> splits = measured(possible, scene, measurement);
  if (!a.json) {
    fmt::print("{}:", text(splits.front()));
    for (const Split& split : splits)
      fmt::print("{} {:.3g} M particle-steps/s",
                 &split == &splits.front() ? "" : fmt::format("; {}", text(split)),
                 split.particle_steps_per_s / 1e6);
    fmt::print(" (measured; --workers and --threads-per-job decide otherwise)\n");
    std::fflush(stdout);
  }
  return splits.front();
}

void work(db::Connection& connection, const RunArguments& a, std::int64_t sweep) {
  const Split split =
      choose_split(a, db::jobs(connection, {sweep, db::JobState::pending}), connection);
  LocalProcesses processes(split.jobs, split.threads);
  RunLoop loop(connection, processes, sweep);
  ProgressLine line;
  loop.run(stop_requests, [&](const CampaignView& view) { line.show(view); });
  line.finish();
}

struct Tally {
  std::size_t total = 0, done = 0, failed = 0, left = 0;
};
Tally tally(const db::Connection& connection, std::int64_t sweep) {
  Tally t;
  for (const db::Job& job : db::jobs(connection, {sweep, std::nullopt})) {
    ++t.total;
    if (job.state == db::JobState::done)
      ++t.done;
    else if (job.state == db::JobState::failed)
      ++t.failed;
    else if (job.state != db::JobState::cancelled)
      ++t.left;
  }
  return t;
}

/// The two pictures beside the database and those asked for by --map.
std::vector<fs::path> draw(const db::Connection& connection, const RunArguments& a,
                           std::int64_t sweep, const std::string& name) {
  std::vector<fs::path> pictures = draw_sweep_maps(connection, sweep, name);
  if (!a.maps.empty()) {
    db::MapFilter filter;
    filter.sweep = sweep;
    draw_named_maps(connection, filter, a.maps);
    pictures.insert(pictures.end(), a.maps.begin(), a.maps.end());
  }
  return pictures;
}

json report_json(const db::Connection& connection, const RunArguments& a, std::int64_t sweep,
                 const std::string& name, const Tally& t, const std::vector<fs::path>& pictures) {
  json failures = json::array();
  for (const db::FailureGroup& f : db::failures(connection, sweep))
    failures.push_back({{"kind", f.kind},
                        {"jobs", f.jobs},
                        {"hash", f.example_hash},
                        {"message", f.example_message}});
  json paths = json::array();
  for (const fs::path& picture : pictures) paths.push_back(picture.string());
  db::ResultFilter filter;
  filter.sweep = sweep;
  return {{"sweep", name},
          {"database", a.database.string()},
          {"jobs", {{"total", t.total}, {"done", t.done}, {"failed", t.failed}, {"left", t.left}}},
          {"results", results_json(db::results(connection, filter))},
          {"failures", std::move(failures)},
          {"pictures", std::move(paths)}};
}

void print_report(const db::Connection& connection, const RunArguments& a, std::int64_t sweep,
                  const Tally& t, const std::vector<fs::path>& pictures) {
  db::ResultFilter filter;
  filter.sweep = sweep;
  fmt::print("\n{}\n", results_table(db::results(connection, filter)));
  fmt::print("{} of {} jobs done", t.done, t.total);
  if (t.failed > 0) fmt::print(", {} failed", t.failed);
  if (t.left > 0) fmt::print(", {} left", t.left);
  fmt::print("\n");
  for (const db::FailureGroup& f : db::failures(connection, sweep))
    fmt::print("failed: {} x {}; for example {}: {}\n", f.jobs, f.kind,
               job_directory(a.database, f.example_hash).path.string(), f.example_message);
  if (t.failed > 0) fmt::print("run again with --retry-failed to try the failed jobs once more\n");
  fmt::print("database: {}\n", a.database.string());
  for (const fs::path& picture : pictures) fmt::print("map:      {}\n", picture.string());
}

}  // namespace

int run(const RunArguments& a) {
  const Sweep sweep = load_sweep(a.sweep, a.overrides);
  const std::vector<Scene> scenes = eerie::expand(sweep);
  const std::vector<db::NewJob> jobs = jobs_of(scenes);
  require_drawable(a.maps, jobs);
  catch_stop_signals();
  hold_signals();
  make_folder_of(a.database);
  const db::Lock lock(a.database);
  db::Connection connection(a.database, db::Access::write);
  const db::AddedSweep added = db::add_sweep(connection, sweep.name, document(sweep), jobs);
  if (a.retry_failed) db::retry_failed(connection, added.sweep);

  const Tally before = tally(connection, added.sweep);
  if (!a.json) {
    if (before.left == 0)
      fmt::print("{}: nothing left to do\n", sweep.name);
    else
      fmt::print("{}: {} jobs, {} new, {} to run\n", sweep.name, added.jobs, added.added,
                 before.left);
    std::fflush(stdout);
  }
  if (before.left > 0) print_warnings(cautions(scenes));
  if (before.left > 0) work(connection, a, added.sweep);

  const Tally after = tally(connection, added.sweep);
  std::vector<fs::path> pictures;
  std::string no_pictures;  // why; the outcomes are told all the same
  try {
    pictures = draw(connection, a, added.sweep, sweep.name);
  } catch (const EnvironmentError& error) {
    no_pictures = error.what();
  }
  if (a.json)
    fmt::print("{}\n",
               report_json(connection, a, added.sweep, sweep.name, after, pictures).dump(1));
  else
    print_report(connection, a, added.sweep, after, pictures);
  if (!no_pictures.empty()) throw EnvironmentError(no_pictures);
  if (after.left > 0) {
    fmt::print(stderr, "stopped; the same command goes on from the checkpoints\n");
    return stopped_by_signal;
  }
  return static_cast<int>(after.failed > 0 ? ExitCode::job_failed : ExitCode::done);
}

}  // namespace eerie::cli
