#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "campaign/manager/inbox.hpp"
#include "campaign/manager/scheduler.hpp"
#include "campaign/manager/space_guard.hpp"
#include "campaign/manager/throughput.hpp"
#include "db/jobs/jobs.hpp"
#include "db/store/connection.hpp"
#include "db/views/query.hpp"

namespace eerie::manager {

/// What a display shows of a campaign at work.
struct CampaignView {
  std::size_t total = 0, done = 0, failed = 0, running = 0, paused = 0;
  double particle_steps_per_s = 0;
  double eta_s = -1;        ///< negative: not known yet
  bool stopping = false;    ///< waits for workers to write their checkpoints
  std::string waiting_for;  ///< why nothing is started, where something could be
};

struct ManagerOptions {
  std::optional<std::int64_t> sweep = {};  ///< works on this one alone; empty: on whatever comes
  bool stays = false;                      ///< waits for requests when nothing is left to do
  bool leaves_workers = false;             ///< workers outlive it: a stop does not concern them
  std::uintmax_t least_free_bytes = 0;     ///< starts nothing with less room on a disk
};

/// Works on jobs until none is pending or a stop is asked for. The only writer of the database;
/// what workers did is read from their files alone.
class Manager {
 public:
  Manager(db::Connection& connection, Scheduler& scheduler, ManagerOptions options);

  /// `stop_requests` counts: 1 stops with checkpoints, 2 at once. `show` is called a few times
  /// per second.
  void run(const std::function<int()>& stop_requests,
           const std::function<void(const CampaignView&)>& show);

  /// Compares what the database says is running with the workers that are there, and settles the
  /// difference. May run at any time.
  void reconcile();

  CampaignView view() const;

 private:
  using Clock = std::chrono::steady_clock;

  struct Running {
    db::Job job;
    std::optional<Clock::time_point> at_work = {};  ///< since its first heartbeat was seen
    bool over_wall_limit = false;
  };

  void round(int stop_requests);
  bool nothing_left() const;
  void obey(int stop_requests);
  void take_requests();
  void refresh();
  void look_at_disks();
  void note_starts();
  void fill_slots();
  void read_ahead(std::size_t free);
  bool prepare(const db::Job& job);
  void adopt(const db::Job& job);
  void start(const std::vector<db::Job>& jobs);
  void wait_for_workers();
  void settle_ended();
  void settle(const Running& run, const std::optional<WorkerEnd>& end);
  void watch();
  void stop_over_limit(Running& run, Clock::time_point now);
  void stop_workers(StopKind kind);
  void drain();
  Task task(const db::Job& job) const;
  void count(const db::Job& job, db::JobState from, db::JobState to);

  db::Connection& connection_;
  Scheduler& scheduler_;
  ManagerOptions options_;
  job_folder::JobFolder folder_;
  Inbox inbox_;
  DiskGuard disks_;
  db::JobCounts counts_;
  std::vector<db::Job> queue_;               ///< jobs to be started next, the very next one last
  std::map<std::int64_t, Running> running_;  ///< with a worker of this manager
  std::map<std::int64_t, Running> foreign_;  ///< with a worker that an earlier one left behind
  std::vector<WorkerEnd> ended_;             ///< not committed yet
  std::vector<db::Start> unnoted_;           ///< started and not committed yet
  int obeyed_ = 0;                           ///< stop requests acted upon
  std::string waiting_for_;
  Clock::time_point retry_at_{};  ///< the scheduler took nothing; it is asked again then
  db::Speed speed_;
  Throughput throughput_;
  Clock::time_point watched_{};
};

}  // namespace eerie::manager
