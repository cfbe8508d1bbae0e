#include "campaign/run_loop.hpp"

#include <algorithm>
#include <filesystem>

#include "campaign/provenance.hpp"
#include "campaign/verdict.hpp"
#include "db/query.hpp"
#include "solver/base/file.hpp"

namespace eerie {
namespace fs = std::filesystem;

namespace {

constexpr auto tick = std::chrono::milliseconds(200);
constexpr auto measuring_interval = std::chrono::seconds(1);

std::optional<double> particle_steps(const JobDirectory& directory) {
  const auto progress = read_progress(directory);
  return progress ? std::optional(progress->particle_steps) : std::nullopt;
}

}  // namespace

RunLoop::RunLoop(db::Connection& connection, Scheduler& scheduler, std::int64_t sweep)
    : connection_(connection), scheduler_(scheduler), sweep_(sweep), throughput_(0, 0) {
  reconcile();
  load();
}

void RunLoop::load() {
  double expected_left = 0;
  pending_.clear();
  done_ = failed_ = 0;
  for (const db::Job& job : db::jobs(connection_, {sweep_, std::nullopt})) {
    members_.insert(job.id);
    if (job.state == db::JobState::done) ++done_;
    if (job.state == db::JobState::failed || job.state == db::JobState::cancelled) ++failed_;
    if (job.state != db::JobState::pending) continue;
    pending_.push_back(job);
    expected_left += job.expected_particle_steps;
  }
  std::reverse(pending_.begin(), pending_.end());
  throughput_ = Throughput(expected_left, db::speed(connection_).expected_over_done);
}

void RunLoop::reconcile() {
  for (const db::Job& job : db::jobs(connection_, {std::nullopt, db::JobState::running})) {
    if (running_.contains(job.id)) continue;
    if (scheduler_.holds(task(job))) {
      foreign_[job.id] = job;
    } else {
      foreign_.erase(job.id);
      settle(job, std::nullopt);
    }
  }
}

void RunLoop::run(const std::function<int()>& stop_requests,
                  const std::function<void(const CampaignView&)>& show) {
  try {
    while (true) {
      obey(stop_requests());
      if (obeyed_ == 0) fill_slots();
      const bool nothing_to_wait_for = obeyed_ > 0 || (pending_.empty() && foreign_.empty());
      if (running_.empty() && nothing_to_wait_for) break;
      for (const WorkerEnd& end : scheduler_.wait(tick)) {
        const db::Job job = running_.at(end.job);
        running_.erase(end.job);
        settle(job, end);
      }
      if (!foreign_.empty()) reconcile();
      measure();
      show(view());
    }
  } catch (...) {
    drain();  // the database or the disk is in trouble; workers still get to write checkpoints
    throw;
  }
}

void RunLoop::obey(int stop_requests) {
  if (stop_requests <= obeyed_) return;
  obeyed_ = stop_requests;
  stop_workers(stop_requests == 1 ? StopKind::with_checkpoint : StopKind::at_once);
}

Task RunLoop::task(const db::Job& job) const {
  return {job.id, job_directory(connection_.path(), job.hash)};
}

void RunLoop::stop_workers(StopKind kind) {
  std::vector<Task> tasks;
  for (const auto& [id, job] : running_) tasks.push_back(task(job));
  scheduler_.stop(tasks, kind);
}

void RunLoop::fill_slots() {
  while (scheduler_.free_slots() > 0 && !pending_.empty()) {
    const db::Job job = pending_.back();
    pending_.pop_back();
    start(job);
  }
}

void RunLoop::start(const db::Job& job) {
  const JobDirectory directory = job_directory(connection_.path(), job.hash);
  throughput_.started(job.id, job.expected_particle_steps);
  // A manager may have been killed between a worker's start and the note of it, or between a
  // worker's result and the note of that.
  if (scheduler_.holds(task(job))) {
    db::begin_attempt(connection_, job.id, host_name(), 0, provenance().version);
    foreign_[job.id] = job;
    return;
  }
  if (read_result(directory, job.hash)) {
    settle(job, std::nullopt);
    return;
  }
  fs::create_directories(directory.path);
  fs::remove(directory.failure());
  install_text(directory.scene(), db::scene(connection_, job.id) + "\n");
  const Task one[] = {task(job)};
  const std::int64_t pid = std::stoll(scheduler_.start(one).front());
  db::begin_attempt(connection_, job.id, host_name(), pid, provenance().version);
  running_[job.id] = job;
}

void RunLoop::settle(db::Job job, const std::optional<WorkerEnd>& end) {
  const JobDirectory directory = job_directory(connection_.path(), job.hash);
  // After a second Ctrl-C the workers die by our own hand, which is no crash of theirs.
  const bool killed_by_us = obeyed_ > 1;
  const Verdict verdict = judge(directory, job.hash, killed_by_us ? std::nullopt : end);
  job.state = commit(connection_, job, verdict, end, particle_steps(directory));
  if (std::holds_alternative<Crashed>(verdict)) ++job.crashes;
  throughput_.ended(job.id, job.state != db::JobState::pending);
  if (!members_.contains(job.id)) return;
  if (job.state == db::JobState::done) ++done_;
  if (job.state == db::JobState::failed) ++failed_;
  if (job.state == db::JobState::pending) pending_.push_back(job);
}

void RunLoop::measure() {
  const auto now = Throughput::Clock::now();
  if (now - measured_ < measuring_interval) return;
  measured_ = now;
  for (const auto* jobs : {&running_, &foreign_})
    for (const auto& [id, job] : *jobs)
      if (const auto progress = read_progress(job_directory(connection_.path(), job.hash)))
        throughput_.progressed(id, *progress);
  throughput_.sample(now);
}

void RunLoop::drain() {
  stop_workers(StopKind::with_checkpoint);
  while (!running_.empty()) {
    for (const WorkerEnd& end : scheduler_.wait(tick)) running_.erase(end.job);
  }
}

CampaignView RunLoop::view() const {
  return {members_.size(),
          done_,
          failed_,
          running_.size() + foreign_.size(),
          throughput_.particle_steps_per_s(),
          throughput_.eta_s(),
          obeyed_ > 0};
}

}  // namespace eerie
