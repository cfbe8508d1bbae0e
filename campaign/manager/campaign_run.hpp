#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "campaign/manager/manager.hpp"
#include "campaign/manager/scheduler.hpp"
#include "campaign/manager/split.hpp"
#include "campaign/manager/throughput.hpp"
#include "campaign/sweeps/job.hpp"
#include "db/jobs/jobs.hpp"
#include "db/store/connection.hpp"

namespace eerie::manager {

/// The user's choice of how to share the cores; 0: the program chooses.
struct Share {
  int workers = 0, threads_per_job = 0;
};

/// The place where the workers of a campaign run, and the options of its manager.
struct Workplace {
  /// Makes the scheduler for a database whose job folder is chosen.
  std::function<std::unique_ptr<Scheduler>(const db::Connection&, const Split&)> scheduler;
  bool is_this_machine = true;  ///< choose_split() then shares its cores
  Share share;
  ManagerOptions options;
};

/// Observes a campaign. Each function may be left out.
class CampaignObserver {
 public:
  virtual ~CampaignObserver() = default;
  /// The work cannot begin yet; told once.
  virtual void waits(const std::string& /*reason*/) {}
  /// Splits of the cores with their speeds; the first, the fastest, is taken.
  virtual void measured(std::span<const Split> /*splits*/) {}
  /// Called a few times per second.
  virtual void at_work(const CampaignView& /*view*/) {}
};

/// Adds a sweep, once no other program holds the database open for writing. Throws StoppedBefore.
db::AddedSweep add_when_free(db::Connection& connection, CampaignObserver& observer,
                             const std::function<db::AddedSweep()>& add);

/// As the user says, else as measured on the longest job; without a measurement, many narrow jobs.
Split choose_split(const Share& share, const std::vector<db::Job>& pending,
                   const db::Connection& connection, CampaignObserver& observer);

/// Runs the pending jobs of a sweep until none is left or a stop is requested. The caller holds the
/// lock of the database and catches stop signals.
void work(db::Connection& connection, std::int64_t sweep, const Workplace& workplace,
          CampaignObserver& observer);

/// The numbers of jobs of a sweep.
struct Tally {
  std::size_t total = 0, done = 0, failed = 0, left = 0;
  std::size_t paused = 0;  ///< number of jobs among `left` that are paused
};
Tally tally(const db::Connection& connection, std::int64_t sweep);
/// {"total", "done", "failed", "left"}, and back.
nlohmann::json to_json(const Tally& tally);
Tally tally_of(const nlohmann::json& document);

/// The first of `runs`, each with a `scene`, that together cost at most `core_hours`.
template <class Run>
std::vector<Run> affordable(std::vector<Run> runs, double core_hours, const db::Speed& speed) {
  double left = core_hours * 3600;
  const auto end = std::ranges::find_if(runs, [&](const Run& run) {
    return (left -= speed.core_seconds_of(sweeps::expected_particle_steps(run.scene))) < 0;
  });
  runs.erase(end, runs.end());
  return runs;
}

/// The speed that a database has measured, or the assumed one.
db::Speed known_speed(const db::Connection& connection);

}  // namespace eerie::manager
