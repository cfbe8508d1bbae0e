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

/// The state of a campaign at work, for displays.
struct CampaignView {
  std::size_t total = 0, done = 0, failed = 0, running = 0, paused = 0;
  double particle_steps_per_s = 0;
  double eta_s = -1;        ///< negative while it is not known
  bool stopping = false;    ///< whether it waits for checkpoints of workers
  std::string waiting_for;  ///< why no job starts although some could
};

struct ManagerOptions {
  std::optional<std::int64_t> sweep = {};  ///< works on this sweep alone; empty: on all jobs
  bool stays = false;                      ///< waits for requests when no job is left
  bool leaves_workers = false;  ///< workers outlive the manager, so a stop does not concern them
  std::uintmax_t least_free_bytes = 0;  ///< starts no job with less free space on a disk
};

/// Works on jobs until none is pending or a stop is requested. It is the only writer of the
/// database, and reads the work of workers from their files alone.
///
/// It waits and tries again where time may help: another program writes to the database, a disk is
/// full, or a result cannot be read. A stop request still ends it within seconds. Results that are
/// not committed then remain in the job directories, from which the next start takes them.
class Manager {
 public:
  Manager(db::Connection& connection, Scheduler& scheduler, ManagerOptions options);

  /// `stop_requests` returns a count: 1 stops with checkpoints, 2 at once. `show` is called a few
  /// times per second, and its exceptions do not stop the manager. Throws db::GoneError where the
  /// database is removed meanwhile, and db::Error where it is damaged, after the workers have
  /// ended.
  void run(const std::function<int()>& stop_requests,
           const std::function<void(const CampaignView&)>& show);

  /// Compares the running jobs of the database with the existing workers and settles the
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
  /// A worker that has ended, whose job is not settled yet.
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
  std::vector<db::Job> queue_;               ///< the next jobs to start; the first of them is last
  std::map<std::int64_t, Running> running_;  ///< jobs with a worker of this manager
  std::map<std::int64_t, Running> foreign_;  ///< jobs with a worker of an earlier manager
  std::vector<Ended> ended_;
  std::vector<db::Start> unnoted_;  ///< started jobs that are not committed yet
  int obeyed_ = 0;                  ///< number of stop requests that it has obeyed
  Clock::time_point kill_at_{}, leave_at_{};
  std::string waiting_for_;  ///< why no job starts; empty where there is no reason
  std::string unread_;       ///< a job that cannot be settled now, with the reason
  Clock::time_point retry_at_{};
  bool is_reconciled_ = false;
  db::Speed speed_;
  Throughput throughput_;
  Clock::time_point watched_{};
};

}  // namespace eerie::manager
