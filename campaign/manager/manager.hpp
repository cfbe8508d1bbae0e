#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "campaign/manager/attempts/awake_time.hpp"
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
///
/// It waits and tries again where time may help: a database that another program writes, a full
/// disk, a result that cannot be read. A stop request ends it all the same, within seconds: what
/// is not committed then lies in the job directories, from which the next start takes it.
class Manager {
 public:
  Manager(db::Connection& connection, Scheduler& scheduler, ManagerOptions options);

  /// `stop_requests` counts: 1 stops with checkpoints, 2 at once. `show` is called a few times
  /// per second; what it throws is no reason to stop. Throws db::GoneError where the database is
  /// removed under it, and db::Error where it is damaged, after the workers have ended.
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
    AwakeTime awake = {};
    bool over_wall_limit = false;
  };
  /// A worker that has ended, of a job that is not settled yet.
  struct Ended {
    WorkerEnd end;
    Clock::time_point retry_at = {};
  };

  void round(int stop_requests);
  void work();
  bool nothing_left();
  bool may_leave();
  void obey(int stop_requests);
  void kill_the_deaf();
  bool must_wait() const { return Clock::now() < retry_at_; }
  void wait_because(const std::string& reason, Clock::duration patience);
  void go_on();
  void take_requests();
  void refresh();
  void look_at_disks();
  void note_starts();
  void fill_slots();
  void read_ahead(std::size_t free);
  bool prepare(const db::Job& job);
  bool make_ready(const db::Job& job);
  void give_up(const db::Job& job, const std::string& reason);
  void adopt(const db::Job& job);
  void start(const std::vector<db::Job>& jobs);
  void wait_for_workers();
  void settle_ended();
  bool try_to_settle(Running& run, const std::optional<WorkerEnd>& end);
  void settle(Running& run, const std::optional<WorkerEnd>& end);
  void watch();
  void stop_over_limit(Running& run);
  void stop_workers(StopKind kind);
  std::size_t workers_at_work() const;
  void drain(const std::function<int()>& stop_requests);
  Task task(const db::Job& job) const;
  void count(const db::Job& job, db::JobState from, db::JobState to);

  db::Connection& connection_;
  Scheduler& scheduler_;
  ManagerOptions options_;
  job_folder::JobFolder folder_;
  Inbox inbox_;
  SpaceGuard disks_;
  db::JobCounts counts_;
  std::vector<db::Job> queue_;               ///< jobs to be started next, the very next one last
  std::map<std::int64_t, Running> running_;  ///< with a worker of this manager
  std::map<std::int64_t, Running> foreign_;  ///< with a worker that an earlier one left behind
  std::vector<Ended> ended_;
  std::vector<db::Start> unnoted_;  ///< started and not committed yet
  int obeyed_ = 0;                  ///< stop requests acted upon
  Clock::time_point kill_at_{}, leave_at_{};
  std::string waiting_for_;  ///< why nothing is started; empty: there is no reason
  std::string unread_;       ///< a job that cannot be settled now, and why
  Clock::time_point retry_at_{};
  bool is_reconciled_ = false;
  db::Speed speed_;
  Throughput throughput_;
  Clock::time_point watched_{};
};

}  // namespace eerie::manager
