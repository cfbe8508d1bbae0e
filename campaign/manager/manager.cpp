#include "campaign/manager/manager.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "campaign/manager/waiting/patience.hpp"
#include "db/store/error.hpp"
#include "db/store/settings.hpp"
#include "solver/base/error.hpp"
#include "solver/base/version.hpp"

namespace eerie::manager {
namespace fs = std::filesystem;

namespace {

/// Before what is in the way is tried again.
constexpr auto trouble_patience = std::chrono::seconds(1);
/// A worker that was told to stop and has not ended by then will not.
constexpr auto grace = std::chrono::seconds(60);
/// For the last commits of a manager that was told to stop.
constexpr auto last_tries = std::chrono::seconds(3);

std::vector<fs::path> disks_of(const db::Connection& connection,
                               const job_folder::JobFolder& jobs) {
  job_folder::require_usable(jobs.root);
  return {fs::absolute(connection.path()).parent_path(), jobs.root};
}

}  // namespace

Manager::Manager(db::Connection& connection, Scheduler& scheduler, ManagerOptions options)
    : connection_(connection),
      scheduler_(scheduler),
      options_(options),
      folder_(job_folder::job_folder(connection)),
      inbox_(connection.path()),
      disks_(disks_of(connection, folder_), options.least_free_bytes),
      speed_(db::speed(connection)),
      throughput_(0, speed_.expected_over_done) {
  if (!speed_.is_measured()) speed_ = assumed_speed;
  counts_ = db::count_jobs(connection_, options_.sweep);
}

void Manager::run(const std::function<int()>& stop_requests,
                  const std::function<void(const CampaignView&)>& show) {
  const LessPatience patience(connection_);
  try {
    do {
      round(stop_requests());
      try {
        show(view());
      } catch (const std::exception&) {  // nobody reads it: a pipe that was closed, a full disk
      }
    } while (!nothing_left());
    connection_.require_in_place();
  } catch (...) {
    drain(stop_requests);  // the database is in trouble; workers still get to write checkpoints
    throw;
  }
}

/// What time may mend is waited for; nothing is forgotten: what could not be committed is in
/// memory, and in the files.
void Manager::round(int stop_requests) {
  obey(stop_requests);
  try {
    work();
    return;
  } catch (const db::FullError& error) {
    disks_.was_full(Clock::now());
    wait_because(error.what(), trouble_patience);
  } catch (const DiskFullError& error) {
    disks_.was_full(Clock::now());
    wait_because(error.what(), trouble_patience);
  } catch (const db::TemporaryError& error) {
    connection_.require_in_place();
    wait_because(error.what(), trouble_patience);
  } catch (const EnvironmentError& error) {
    wait_because(error.what(), trouble_patience);
  } catch (const std::system_error& error) {
    wait_because(error.what(), trouble_patience);
  }
  wait_for_workers();
}

void Manager::work() {
  if (!is_reconciled_) {
    db::set(connection_, "solver_version", solver_version);
    db::set(connection_, "database_name", connection_.path().filename().string());
    reconcile();
    refresh();
    is_reconciled_ = true;
  }
  look_at_disks();
  note_starts();
  take_requests();
  fill_slots();
  wait_for_workers();
  settle_ended();
  watch();
  if (!must_wait()) go_on();
}

bool Manager::nothing_left() {
  if (obeyed_ > 0) return options_.leaves_workers || may_leave();
  if (!is_reconciled_) return false;
  if (options_.stays || !running_.empty() || !foreign_.empty() || !queue_.empty()) return false;
  return counts_[db::JobState::pending] == counts_.paused;
}

/// Of a manager that was told to stop: whether its workers have ended, and their ends are noted or
/// cannot be.
bool Manager::may_leave() {
  if (workers_at_work() > 0) return false;
  if (ended_.empty() && unnoted_.empty()) return true;
  if (leave_at_ == Clock::time_point{}) leave_at_ = Clock::now() + last_tries;
  if (Clock::now() < leave_at_) return false;
  spdlog::warn("event=left-unsettled jobs={} reason=\"{}\"", ended_.size(),
               waiting_for_.empty() ? unread_ : waiting_for_);
  return true;
}

void Manager::obey(int stop_requests) {
  kill_the_deaf();
  if (stop_requests <= obeyed_) return;
  if (obeyed_ == 0) kill_at_ = Clock::now() + grace;
  obeyed_ = stop_requests;
  spdlog::info("event=stop requests={} running={}", stop_requests, running_.size());
  if (!options_.leaves_workers)
    stop_workers(stop_requests == 1 ? StopKind::with_checkpoint : StopKind::at_once);
}

void Manager::kill_the_deaf() {
  if (obeyed_ != 1 || options_.leaves_workers || Clock::now() < kill_at_) return;
  spdlog::warn("event=kill running={} reason=\"not ended after {} s\"", workers_at_work(),
               std::chrono::seconds(grace).count());
  stop_workers(StopKind::at_once);
  obeyed_ = 2;
}

void Manager::wait_because(const std::string& reason, Clock::duration patience) {
  if (waiting_for_.empty()) spdlog::warn("event=waiting reason=\"{}\"", reason);
  waiting_for_ = reason;
  retry_at_ = Clock::now() + patience;
}

void Manager::go_on() {
  if (!waiting_for_.empty()) spdlog::info("event=going-on");
  waiting_for_.clear();
}

void Manager::look_at_disks() {
  if (const auto complaint = disks_.complaint(Clock::now()))
    wait_because(*complaint, trouble_patience);
}

void Manager::take_requests() {
  if (must_wait() && !inbox_.is_empty() && disks_.complaint(Clock::now())) return;
  if (inbox_.take(connection_) > 0) refresh();
}

/// What the database wants, read anew: after requests, and at the start.
void Manager::refresh() {
  counts_ = db::count_jobs(connection_, options_.sweep);
  throughput_.waiting(counts_.expected_particle_steps);
  queue_.clear();
  std::vector<Task> unwanted;
  for (const db::Job& job : db::unwanted_jobs(connection_))
    if (running_.contains(job.id) || foreign_.contains(job.id)) unwanted.push_back(task(job));
  if (!unwanted.empty()) scheduler_.stop(unwanted, StopKind::with_checkpoint);
  for (const db::Job& job : db::jobs(connection_, {std::nullopt, db::JobState::running}))
    if (const auto run = running_.find(job.id); run != running_.end())
      run->second.job.wall_limit_s = job.wall_limit_s, run->second.job.wall_s = job.wall_s;
}

void Manager::stop_workers(StopKind kind) {
  std::vector<Task> tasks;
  for (const auto& [id, run] : running_) tasks.push_back(task(run.job));
  scheduler_.stop(tasks, kind);
}

std::size_t Manager::workers_at_work() const {
  return static_cast<std::size_t>(std::ranges::count_if(running_, [this](const auto& run) {
    return std::ranges::none_of(ended_,
                                [&](const Ended& ended) { return ended.end.job == run.first; });
  }));
}

/// Ends the workers, without the database.
void Manager::drain(const std::function<int()>& stop_requests) {
  if (options_.leaves_workers) return;
  const int before = stop_requests();
  stop_workers(StopKind::with_checkpoint);
  const auto kill_at = Clock::now() + grace, give_up_at = kill_at + std::chrono::seconds(10);
  while (workers_at_work() > 0 && Clock::now() < give_up_at) {
    wait_for_workers();
    if (Clock::now() > kill_at || stop_requests() > before) stop_workers(StopKind::at_once);
  }
}

Task Manager::task(const db::Job& job) const {
  return {job.id, folder_.of(job.hash), speed_.core_seconds_of(job.expected_particle_steps)};
}

/// Jobs of other sweeps may be settled in passing; they are not counted.
void Manager::count(const db::Job& job, db::JobState from, db::JobState to) {
  if (options_.sweep && !db::is_member(connection_, *options_.sweep, job.id)) return;
  --counts_.in_state.at(static_cast<std::size_t>(from));
  ++counts_.in_state.at(static_cast<std::size_t>(to));
}

CampaignView Manager::view() const {
  return {counts_.total() - counts_[db::JobState::cancelled],
          counts_[db::JobState::done],
          counts_[db::JobState::failed],
          running_.size() + foreign_.size(),
          counts_.paused,
          throughput_.particle_steps_per_s(),
          throughput_.eta_s(),
          obeyed_ > 0,
          waiting_for_.empty() ? unread_ : waiting_for_};
}

}  // namespace eerie::manager
