#pragma once

#include <functional>
#include <map>
#include <unordered_set>

#include "campaign/scheduler.hpp"
#include "campaign/throughput.hpp"
#include "db/connection.hpp"
#include "db/jobs.hpp"

namespace eerie {

/// What a display shows of a campaign at work.
struct CampaignView {
  std::size_t total = 0, done = 0, failed = 0, running = 0;
  double particle_steps_per_s = 0;
  double eta_s = -1;      ///< negative: not known yet
  bool stopping = false;  ///< waits for workers to write their checkpoints
};

/// Works on the jobs of one sweep until none is pending or a stop is asked for. The only writer
/// of the database; what workers did is read from their files alone.
class RunLoop {
 public:
  RunLoop(db::Connection& connection, Scheduler& scheduler, std::int64_t sweep);

  /// Compares what the database says is running with the files and processes that are there,
  /// and settles the difference. May run at any time.
  void reconcile();

  /// `stop_requests` counts: 1 stops with checkpoints, 2 at once. `show` is called a few times
  /// per second.
  void run(const std::function<int()>& stop_requests,
           const std::function<void(const CampaignView&)>& show);

  CampaignView view() const;

 private:
  void load();
  Task task(const db::Job& job) const;
  void stop_workers(StopKind kind);
  void obey(int stop_requests);
  void fill_slots();
  void start(const db::Job& job);
  void settle(db::Job job, const std::optional<WorkerEnd>& end);
  void measure();
  void drain();

  db::Connection& connection_;
  Scheduler& scheduler_;
  std::int64_t sweep_;
  std::unordered_set<std::int64_t> members_;  ///< jobs of the sweep
  std::vector<db::Job> pending_;              ///< the next one last
  std::map<std::int64_t, db::Job> running_;   ///< with a worker of this process
  std::map<std::int64_t, db::Job> foreign_;   ///< with a worker that an earlier manager left behind
  std::size_t done_ = 0, failed_ = 0;
  int obeyed_ = 0;  ///< stop requests acted upon
  Throughput throughput_;
  Throughput::Clock::time_point measured_{};
};

}  // namespace eerie
