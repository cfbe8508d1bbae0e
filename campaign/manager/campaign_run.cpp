#include "campaign/manager/campaign_run.hpp"

#include <nlohmann/json.hpp>

#include "campaign/manager/status_file.hpp"
#include "campaign/manager/waiting/patience.hpp"
#include "campaign/process/cores.hpp"
#include "campaign/process/signals.hpp"

namespace eerie::manager {
namespace {

/// Core-seconds of work from which on measuring splits pays, and what a measurement takes.
constexpr double worth_measuring_s = 120, least_speed = 2e6;
constexpr std::chrono::duration<double> measurement{0.4};

}  // namespace

db::AddedSweep add_when_free(db::Connection& connection, CampaignObserver& observer,
                             const std::function<db::AddedSweep()>& add) {
  db::AddedSweep added;
  when_free(
      connection, [&] { added = add(); },
      [&](const std::string& reason) { observer.waits(reason); });
  return added;
}

Split choose_split(const Share& share, const std::vector<db::Job>& pending,
                   const db::Connection& connection, CampaignObserver& observer) {
  const std::size_t cores = process::usable_cores();
  const auto threads = static_cast<std::size_t>(std::max(1, share.threads_per_job));
  if (share.workers > 0)
    return {static_cast<std::size_t>(share.workers), static_cast<int>(threads), 0};
  if (share.threads_per_job > 0)
    return {std::max<std::size_t>(1, cores / threads), share.threads_per_job, 0};
  double particle_steps = 0;
  for (const db::Job& job : pending) particle_steps += job.expected_particle_steps;
  const std::vector<Split> possible = possible_splits(cores, pending.size());
  if (possible.size() == 1 || particle_steps / least_speed < worth_measuring_s)
    return possible.front();
  const auto longest = std::ranges::max_element(pending, {}, &db::Job::expected_particle_steps);
  const Scene scene = parse_scene(nlohmann::json::parse(db::scene(connection, longest->id)));
  const std::vector<Split> splits = manager::measured(possible, scene, measurement);
  observer.measured(splits);
  return splits.front();
}

void work(db::Connection& connection, std::int64_t sweep, const Workplace& workplace,
          CampaignObserver& observer) {
  Split split;
  if (workplace.is_this_machine)
    split = choose_split(workplace.share, db::jobs(connection, {sweep, db::JobState::pending}),
                         connection, observer);
  const std::unique_ptr<Scheduler> scheduler = workplace.scheduler(connection, split);
  ManagerOptions options = workplace.options;
  options.sweep = sweep;
  Manager manager(connection, *scheduler, options);
  StatusFile status(connection.path());
  manager.run(process::stop_requests, [&](const CampaignView& view) {
    status.show(view);
    observer.at_work(view);
  });
}

Tally tally(const db::Connection& connection, std::int64_t sweep) {
  const db::JobCounts counts = db::count_jobs(connection, sweep);
  return {counts.total(), counts[db::JobState::done], counts[db::JobState::failed],
          counts[db::JobState::pending] + counts[db::JobState::running], counts.paused};
}

nlohmann::json to_json(const Tally& t) {
  return {{"total", t.total}, {"done", t.done}, {"failed", t.failed}, {"left", t.left}};
}

Tally tally_of(const nlohmann::json& document) {
  Tally t;
  document.at("total").get_to(t.total), document.at("done").get_to(t.done);
  document.at("failed").get_to(t.failed), document.at("left").get_to(t.left);
  return t;
}

db::Speed known_speed(const db::Connection& connection) {
  const db::Speed speed = db::speed(connection);
  return speed.is_measured() ? speed : assumed_speed;
}

}  // namespace eerie::manager
