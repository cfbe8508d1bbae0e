#include "campaign/cli/work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "campaign/cli/output/progress_line.hpp"
#include "campaign/manager/local_processes.hpp"
#include "campaign/manager/manager.hpp"
#include "campaign/manager/split.hpp"
#include "campaign/manager/status_file.hpp"
#include "campaign/process/signals.hpp"
#include "db/jobs/jobs.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Core-seconds of work from which on measuring splits pays, and what a measurement takes.
constexpr double worth_measuring_s = 120, least_speed = 2e6;
constexpr std::chrono::duration<double> measurement{0.4};

std::string text(const manager::Split& split) {
  return fmt::format("{} job{} x {} thread{}", split.jobs, split.jobs == 1 ? "" : "s",
                     split.threads, split.threads == 1 ? "" : "s");
}

/// As the user says, else as measured on the longest job; without a measurement, many narrow jobs.
manager::Split choose_split(const Share& share, const std::vector<db::Job>& pending,
                            const db::Connection& connection) {
  const std::size_t cores = manager::usable_cores();
  const auto threads = static_cast<std::size_t>(std::max(1, share.threads_per_job));
  if (share.workers > 0)
    return {static_cast<std::size_t>(share.workers), static_cast<int>(threads), 0};
  if (share.threads_per_job > 0)
    return {std::max<std::size_t>(1, cores / threads), share.threads_per_job, 0};
  double particle_steps = 0;
  for (const db::Job& job : pending) particle_steps += job.expected_particle_steps;
  const std::vector<manager::Split> possible = manager::possible_splits(cores, pending.size());
  if (possible.size() == 1 || particle_steps / least_speed < worth_measuring_s)
    return possible.front();
  const auto longest = std::ranges::max_element(pending, {}, &db::Job::expected_particle_steps);
  const Scene scene = parse_scene(json::parse(db::scene(connection, longest->id)));
  const std::vector<manager::Split> splits = manager::measured(possible, scene, measurement);
  if (!share.quiet) {
    fmt::print("{}:", text(splits.front()));
    for (const manager::Split& split : splits)
      fmt::print("{} {:.3g} M particle-steps/s",
                 &split == &splits.front() ? "" : fmt::format("; {}", text(split)),
                 split.particle_steps_per_s / 1e6);
    fmt::print(" (measured; --workers and --threads-per-job decide otherwise)\n");
    std::fflush(stdout);
  }
  return splits.front();
}

}  // namespace

void make_folder_of(const fs::path& file) {
  if (!file.has_parent_path()) return;
  std::error_code problem;
  fs::create_directories(file.parent_path(), problem);
  if (problem)
    throw EnvironmentError(fmt::format("cannot make the folder {}: {}; give another file",
                                       file.parent_path().string(), problem.message()));
}

void work(db::Connection& connection, const Share& share, std::int64_t sweep,
          const EngineArguments& engine) {
  manager::Split split;
  if (engine.is_local())
    split = choose_split(share, db::jobs(connection, {sweep, db::JobState::pending}), connection);
  open_manager_log(connection.path(), false);
  const auto scheduler = make_scheduler(engine, connection, split.jobs, split.threads);
  manager::ManagerOptions options = manager_options(engine);
  options.sweep = sweep;
  manager::Manager manager(connection, *scheduler, options);
  ProgressLine line;
  manager::StatusFile status(connection.path());
  manager.run(process::stop_requests, [&](const manager::CampaignView& view) {
    line.show(view);
    status.show(view);
  });
  line.finish();
}

Tally tally(const db::Connection& connection, std::int64_t sweep) {
  const db::JobCounts counts = db::count_jobs(connection, sweep);
  return {counts.total(), counts[db::JobState::done], counts[db::JobState::failed],
          counts[db::JobState::pending] + counts[db::JobState::running], counts.paused};
}

}  // namespace eerie::cli
