// How a manager learns what became of workers.

#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "campaign/manager/attempts/attempt_verdict.hpp"
#include "campaign/manager/attempts/half_written.hpp"
#include "campaign/manager/manager.hpp"
#include "db/store/error.hpp"
#include "solver/base/error.hpp"
#include "solver/base/kill_point.hpp"

namespace eerie::manager {
namespace fs = std::filesystem;

namespace {

constexpr auto tick = std::chrono::milliseconds(200);
/// Before a result that could not be read is tried again.
constexpr auto unread_patience = std::chrono::seconds(2);

/// Each second, or less often where so many workers are asked that asking would be work.
std::chrono::milliseconds watching_interval(std::size_t workers) {
  return std::chrono::milliseconds(std::max<std::size_t>(1000, 5 * workers));
}

std::optional<double> particle_steps(const job_folder::JobDirectory& directory) {
  const auto progress = job_folder::read_progress(directory);
  return progress ? std::optional(progress->particle_steps) : std::nullopt;
}

}  // namespace

void Manager::wait_for_workers() {
  for (WorkerEnd& end : scheduler_.wait(tick)) ended_.push_back({std::move(end)});
}

void Manager::settle_ended() {
  const bool all_were_read = std::ranges::none_of(
      ended_, [](const Ended& ended) { return ended.retry_at != Clock::time_point{}; });
  if (all_were_read && foreign_.empty()) unread_.clear();
  for (std::size_t k = ended_.size(); k-- > 0;) {
    if (Clock::now() < ended_[k].retry_at) continue;
    const auto run = running_.find(ended_[k].end.job);
    if (run != running_.end()) {
      if (!try_to_settle(run->second, ended_[k].end)) {
        ended_[k].retry_at = Clock::now() + unread_patience;
        continue;
      }
      running_.erase(run);
    }
    ended_.erase(ended_.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

/// False where its files cannot be read now: maybe they can later.
bool Manager::try_to_settle(Running& run, const std::optional<WorkerEnd>& end) {
  std::string reason;
  try {
    settle(run, end);
    return true;
  } catch (const DiskFullError&) {
    throw;
  } catch (const EnvironmentError& error) {
    reason = error.what();
  } catch (const std::system_error& error) {
    reason = error.what();
  }
  if (unread_ != reason)
    spdlog::warn("event=unsettled job={} reason=\"{}\"", run.job.hash.substr(0, 16), reason);
  unread_ = reason;
  return false;
}

void Manager::settle(Running& run, const std::optional<WorkerEnd>& end) {
  const job_folder::JobDirectory directory = folder_.of(run.job.hash);
  // After a second Ctrl-C the workers die by our own hand, which is no crash of theirs.
  const bool killed_by_us = obeyed_ > 1;
  const AttemptVerdict verdict =
      judge_attempt(directory, run.job.hash, killed_by_us ? std::nullopt : end);
  run.awake.look(directory, Clock::now());
  const Attempt attempt{end, job_folder::read_ended(directory), particle_steps(directory),
                        run.awake.seconds(), run.over_wall_limit};
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
    Running& run = foreign_.try_emplace(job.id, Running{job}).first->second;
    run.job = job;
    if (!scheduler_.holds(task(job)) && try_to_settle(run, std::nullopt)) foreign_.erase(job.id);
  }
}

/// Reads how far the workers are, ends what takes too long, and sees to those left behind.
void Manager::watch() {
  const auto now = Clock::now();
  if (now - watched_ < watching_interval(running_.size())) return;
  watched_ = now;
  connection_.require_in_place();
  for (auto* runs : {&running_, &foreign_})
    for (auto& [id, run] : *runs) {
      const job_folder::JobDirectory directory = folder_.of(run.job.hash);
      if (const auto progress = job_folder::read_progress(directory))
        throughput_.progressed(id, *progress);
      run.awake.look(directory, now);
      stop_over_limit(run);
    }
  throughput_.sample(now);
  if (!foreign_.empty()) reconcile();
}

void Manager::stop_over_limit(Running& run) {
  const double here = run.awake.seconds(), spent = run.job.wall_s + here;
  if (!run.job.wall_limit_s || here <= 0 || spent <= *run.job.wall_limit_s) return;
  // A worker that does not end within a minute will not.
  constexpr double grace_s = 60;
  const Task one[] = {task(run.job)};
  if (!run.over_wall_limit || spent > *run.job.wall_limit_s + grace_s)
    scheduler_.stop(one, run.over_wall_limit ? StopKind::at_once : StopKind::with_checkpoint);
  run.over_wall_limit = true;
}

}  // namespace eerie::manager
