// How a manager starts workers.

#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "campaign/job_folder/provenance.hpp"
#include "campaign/job_folder/result_file.hpp"
#include "campaign/manager/attempts/half_written.hpp"
#include "campaign/manager/manager.hpp"
#include "campaign/manager/waiting/try_later.hpp"
#include "db/store/error.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/kill_point.hpp"
#include "solver/base/version.hpp"

namespace eerie::manager {
namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds scheduler_patience{10};
constexpr std::size_t queue_length = 256;

/// A result that another solver version made is kept, under its version's name.
void set_aside_stale_result(const job_folder::JobDirectory& directory,
                            const job_folder::StoredResult& stored) {
  fs::rename(directory.result(),
             directory.path / ("result-" + stored.result.solver_version + ".json"));
}

}  // namespace

void Manager::fill_slots() {
  while (obeyed_ == 0 && !must_wait()) {
    const std::size_t free = scheduler_.free_slots();
    if (free == 0) return;
    if (queue_.empty()) read_ahead(free);
    std::vector<db::Job> batch;
    while (batch.size() < free && !queue_.empty()) {
      const db::Job job = queue_.back();
      queue_.pop_back();
      if (prepare(job)) batch.push_back(job);
    }
    if (must_wait() || (batch.empty() && queue_.empty())) return;
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
/// manager's is there still, or got through unnoted, or the disk is full. A directory that nothing
/// can be done with fails its job, and no other.
bool Manager::prepare(const db::Job& job) {
  std::string trouble;
  try {
    return make_ready(job);
  } catch (const DiskFullError& error) {
    disks_.was_full(Clock::now());
    wait_because(error.what(), std::chrono::milliseconds(200));
    queue_.clear();
    return false;
  } catch (const EnvironmentError& error) {
    trouble = error.what();
  } catch (const std::system_error& error) {
    trouble = error.what();
  }
  job_folder::require_usable(folder_.root);  // else it is the trouble of all jobs
  give_up(job, trouble);
  return false;
}

bool Manager::make_ready(const db::Job& job) {
  const job_folder::JobDirectory directory = folder_.of(job.hash);
  if (scheduler_.holds(task(job))) {
    adopt(job);
    return false;
  }
  job_folder::require_usable(directory);
  if (const auto stored = job_folder::read_result(directory, job.hash)) {
    if (stored->result.solver_version == solver_version) {
      adopt(job);
      reconcile();
      return false;
    }
    set_aside_stale_result(directory, *stored);
  }
  for (const fs::path& old :
       {directory.failure(), directory.ended(), directory.stop(), directory.heartbeat()})
    fs::remove(old);
  remove_half_written(directory);
  install_text(directory.scene(), db::scene(connection_, job.id) + "\n");
  return true;
}

/// The job has failed before a worker could begin.
void Manager::give_up(const db::Job& job, const std::string& reason) {
  db::begin_attempts(connection_, std::vector{db::Start{job.id, job_folder::host_name(), "",
                                                        job_folder::provenance().version}});
  const db::AttemptEnd end{
      .reason = db::ExitReason::failed, .failure_kind = "job-directory", .message = reason};
  const db::JobState state = db::end_attempt(connection_, job.id, end, db::JobState::failed);
  spdlog::error("event=ended job={} state=failed reason=\"{}\"", job.hash.substr(0, 16), reason);
  count(job, db::JobState::pending, state);
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
    const auto* later = dynamic_cast<const TryLater*>(&error);
    wait_because(error.what(), later != nullptr ? later->patience : scheduler_patience);
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

}  // namespace eerie::manager
