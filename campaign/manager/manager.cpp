#include "campaign/manager/manager.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>

#include "campaign/job_folder/provenance.hpp"
#include "campaign/job_folder/worker_lock.hpp"
#include "campaign/manager/attempt_verdict.hpp"
#include "db/store/error.hpp"
#include "db/store/settings.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/kill_point.hpp"
#include "solver/base/version.hpp"

namespace eerie::manager {
namespace fs = std::filesystem;

namespace {

constexpr auto tick = std::chrono::milliseconds(200);
constexpr auto engine_patience = std::chrono::seconds(10);
constexpr std::size_t queue_length = 256;

/// Each second, or less often where so many workers are asked that asking would be work.
std::chrono::milliseconds watching_interval(std::size_t workers) {
  return std::chrono::milliseconds(std::max<std::size_t>(1000, 5 * workers));
}

std::vector<fs::path> disks_of(const db::Connection& connection,
                               const job_folder::JobFolder& jobs) {
  fs::create_directories(jobs.root);
  return {fs::absolute(connection.path()).parent_path(), jobs.root};
}

std::optional<double> particle_steps(const job_folder::JobDirectory& directory) {
  const auto progress = job_folder::read_progress(directory);
  return progress ? std::optional(progress->particle_steps) : std::nullopt;
}

/// What a manager or a worker left that was killed while it wrote.
void remove_half_written(const job_folder::JobDirectory& directory) {
  if (job_folder::WorkerLock::held(directory)) return;  // they may be of a writer at work
  for (const fs::path& half : half_written_files(directory.path)) {
    std::error_code error;
    if (fs::remove(half, error); error)  // no reason to stop a campaign
      spdlog::warn("event=litter file=\"{}\" reason=\"{}\"", half.string(), error.message());
  }
}

/// A result that another solver version made is kept, under its version's name.
void set_aside_stale_result(const job_folder::JobDirectory& directory,
                            const job_folder::StoredResult& stored) {
  fs::rename(directory.result(),
             directory.path / ("result-" + stored.result.solver_version + ".json"));
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
  db::set(connection, "solver_version", solver_version);
  reconcile();
  refresh();
}

void Manager::run(const std::function<int()>& stop_requests,
                  const std::function<void(const CampaignView&)>& show) {
  try {
    do {
      round(stop_requests());
      show(view());
    } while (!nothing_left());
  } catch (...) {
    drain();  // the database is in trouble; workers still get to write checkpoints
    throw;
  }
}

void Manager::round(int stop_requests) {
  try {
    obey(stop_requests);
    look_at_disks();
    note_starts();
    take_requests();
    fill_slots();
    wait_for_workers();
    settle_ended();
    watch();
  } catch (const db::FullError& error) {
    // Nothing is forgotten: what could not be committed is in memory, and in the files.
    if (waiting_for_.empty()) spdlog::error("event=disk-full message=\"{}\"", error.what());
    waiting_for_ = error.what();
    disks_.was_full(Clock::now());
    wait_for_workers();
  }
}

bool Manager::nothing_left() const {
  if (obeyed_ > 0) return running_.empty() || options_.leaves_workers;
  if (options_.stays || !running_.empty() || !foreign_.empty() || !queue_.empty()) return false;
  return counts_[db::JobState::pending] == counts_.paused;
}

void Manager::obey(int stop_requests) {
  if (stop_requests <= obeyed_) return;
  obeyed_ = stop_requests;
  spdlog::info("event=stop requests={} running={}", stop_requests, running_.size());
  if (!options_.leaves_workers)
    stop_workers(stop_requests == 1 ? StopKind::with_checkpoint : StopKind::at_once);
}

void Manager::look_at_disks() {
  const auto complaint = disks_.complaint(Clock::now());
  if (complaint && waiting_for_.empty()) spdlog::warn("event=waiting reason=\"{}\"", *complaint);
  if (!complaint && !waiting_for_.empty() && Clock::now() >= retry_at_)
    spdlog::info("event=going-on");
  if (complaint)
    waiting_for_ = *complaint;
  else if (Clock::now() >= retry_at_)
    waiting_for_.clear();
}

void Manager::take_requests() {
  if (!waiting_for_.empty() && !inbox_.is_empty() && disks_.complaint(Clock::now())) return;
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

void Manager::fill_slots() {
  while (obeyed_ == 0 && waiting_for_.empty()) {
    const std::size_t free = scheduler_.free_slots();
    if (free == 0) return;
    if (queue_.empty()) read_ahead(free);
    std::vector<db::Job> batch;
    while (batch.size() < free && !queue_.empty()) {
      const db::Job job = queue_.back();
      queue_.pop_back();
      if (prepare(job)) batch.push_back(job);
    }
    if (!waiting_for_.empty() || (batch.empty() && queue_.empty())) return;
    if (!batch.empty()) start(batch);
  }
}

void Manager::read_ahead(std::size_t free) {
  queue_ = db::next_jobs(connection_, options_.sweep, std::max(queue_length, free));
  // Started, and not noted yet.
  std::erase_if(queue_, [&](const db::Job& job) { return running_.contains(job.id); });
  std::ranges::reverse(queue_);
}

/// Makes the job directory ready for a worker; false where none is to be started: an earlier
/// manager's is there still, or got through unnoted, or the disk is full.
bool Manager::prepare(const db::Job& job) {
  const job_folder::JobDirectory directory = folder_.of(job.hash);
  try {
    if (scheduler_.holds(task(job))) {
      adopt(job);
      return false;
    }
    if (const auto stored = job_folder::read_result(directory, job.hash)) {
      if (stored->result.solver_version == solver_version) {
        adopt(job);
        reconcile();
        return false;
      }
      set_aside_stale_result(directory, *stored);
    }
    fs::create_directories(directory.path);
    for (const fs::path& old :
         {directory.failure(), directory.ended(), directory.stop(), directory.heartbeat()})
      fs::remove(old);
    remove_half_written(directory);
    install_text(directory.scene(), db::scene(connection_, job.id) + "\n");
    return true;
  } catch (const DiskFullError& error) {
    disks_.was_full(Clock::now());
    waiting_for_ = error.what();
    queue_.clear();
    return false;
  }
}

/// Notes that a worker of an earlier manager is, or was, at the job.
void Manager::adopt(const db::Job& job) {
  db::begin_attempts(connection_, std::vector{db::Start{job.id, job_folder::host_name(), "",
                                                        job_folder::provenance().version}});
  throughput_.started(job.id, job.expected_particle_steps);
  count(job, db::JobState::pending, db::JobState::running);
  foreign_[job.id] = {job};
}

void Manager::start(const std::vector<db::Job>& jobs) {
  std::vector<Task> tasks;
  for (const db::Job& job : jobs) tasks.push_back(task(job));
  std::vector<std::string> names;
  try {
    names = scheduler_.start(tasks);
  } catch (const SchedulerUnavailable& error) {
    spdlog::warn("event=engine-unavailable message=\"{}\"", error.what());
    waiting_for_ = error.what();
    retry_at_ = Clock::now() + engine_patience;
    queue_.clear();
    return;
  }
  const std::string version = job_folder::provenance().version;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    spdlog::info("event=started job={} worker=\"{}\" attempt_crashes={}",
                 jobs[i].hash.substr(0, 16), names[i], jobs[i].crashes);
    throughput_.started(jobs[i].id, jobs[i].expected_particle_steps);
    count(jobs[i], db::JobState::pending, db::JobState::running);
    running_[jobs[i].id] = {jobs[i]};
    unnoted_.push_back({jobs[i].id, job_folder::host_name(), names[i], version});
  }
  note_starts();
}

void Manager::note_starts() {
  if (unnoted_.empty()) return;
  kill_point("manager.before-note");
  db::begin_attempts(connection_, unnoted_);
  unnoted_.clear();
}

void Manager::wait_for_workers() {
  for (WorkerEnd& end : scheduler_.wait(tick)) ended_.push_back(std::move(end));
}

void Manager::settle_ended() {
  while (!ended_.empty()) {
    const auto run = running_.find(ended_.back().job);
    if (run != running_.end()) {
      settle(run->second, ended_.back());
      running_.erase(run);
    }
    ended_.pop_back();
  }
}

void Manager::settle(const Running& run, const std::optional<WorkerEnd>& end) {
  const job_folder::JobDirectory directory = folder_.of(run.job.hash);
  // After a second Ctrl-C the workers die by our own hand, which is no crash of theirs.
  const bool killed_by_us = obeyed_ > 1;
  const AttemptVerdict verdict =
      judge_attempt(directory, run.job.hash, killed_by_us ? std::nullopt : end);
  Attempt attempt{end, job_folder::read_ended(directory), particle_steps(directory), 0,
                  run.over_wall_limit};
  if (run.at_work)
    attempt.wall_s = std::chrono::duration<double>(Clock::now() - *run.at_work).count();
  remove_half_written(directory);
  kill_point("manager.before-commit");
  const db::JobState state = commit(connection_, run.job, verdict, attempt);
  kill_point("manager.after-commit");
  spdlog::info("event=ended job={} state={}", run.job.hash.substr(0, 16),
               db::job_state_names.at(static_cast<std::size_t>(state)));
  if (std::holds_alternative<DiskFull>(verdict)) disks_.was_full(Clock::now());
  if (std::holds_alternative<HasResult>(verdict)) disks_.was_well();
  throughput_.ended(run.job.id, state != db::JobState::pending);
  if (state == db::JobState::pending) {
    counts_ = db::count_jobs(connection_, options_.sweep);  // paused, maybe
    queue_.clear();
  } else {
    count(run.job, db::JobState::running, state);
  }
}

void Manager::reconcile() {
  for (const db::Job& job : db::jobs(connection_, {std::nullopt, db::JobState::running})) {
    if (running_.contains(job.id)) continue;
    if (scheduler_.holds(task(job))) {
      foreign_.try_emplace(job.id, Running{job});
    } else {
      settle({job}, std::nullopt);
      foreign_.erase(job.id);
    }
  }
}

/// Reads how far the workers are, ends what takes too long, and sees to those left behind.
void Manager::watch() {
  const auto now = Clock::now();
  if (now - watched_ < watching_interval(running_.size())) return;
  watched_ = now;
  for (auto* runs : {&running_, &foreign_})
    for (auto& [id, run] : *runs) {
      const job_folder::JobDirectory directory = folder_.of(run.job.hash);
      if (const auto progress = job_folder::read_progress(directory))
        throughput_.progressed(id, *progress);
      if (!run.at_work && fs::exists(directory.heartbeat())) run.at_work = now;
      stop_over_limit(run, now);
    }
  throughput_.sample(now);
  if (!foreign_.empty()) reconcile();
}

void Manager::stop_over_limit(Running& run, Clock::time_point now) {
  if (!run.job.wall_limit_s || !run.at_work) return;
  const double spent = run.job.wall_s + std::chrono::duration<double>(now - *run.at_work).count();
  if (spent <= *run.job.wall_limit_s) return;
  // A worker that does not end within a minute will not.
  constexpr double grace_s = 60;
  const Task one[] = {task(run.job)};
  if (!run.over_wall_limit || spent > *run.job.wall_limit_s + grace_s)
    scheduler_.stop(one, run.over_wall_limit ? StopKind::at_once : StopKind::with_checkpoint);
  run.over_wall_limit = true;
}

void Manager::stop_workers(StopKind kind) {
  std::vector<Task> tasks;
  for (const auto& [id, run] : running_) tasks.push_back(task(run.job));
  scheduler_.stop(tasks, kind);
}

void Manager::drain() {
  if (options_.leaves_workers) return;
  stop_workers(StopKind::with_checkpoint);
  while (!running_.empty())
    for (const WorkerEnd& end : scheduler_.wait(tick)) running_.erase(end.job);
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
          waiting_for_};
}

}  // namespace eerie::manager
