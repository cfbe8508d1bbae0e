#include "campaign/slurm/live_batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "campaign/job_folder/worker_exit.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::slurm {
namespace fs = std::filesystem;

namespace {

/// One answer without an array task may be a slip (a controller that restarts answers with an
/// empty queue); a submission of unknown fate may still be on its way.
constexpr int absences_of_the_gone = 2, absences_of_the_unknown = 6;

/// Over NFS a file that was missing a moment ago is taken to be missing still, unless its folder
/// is opened anew.
void look_again(const fs::path& folder) {
  std::error_code ignored;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder, ignored)) break;
}

/// What the array task said outside of any job, such as why the program could not be started,
/// for those who look into the job's log.
void explain_loss(const Batch& batch, int index, const job_folder::JobDirectory& directory) {
  constexpr std::size_t longest = 2000;
  std::error_code problem;
  std::string text =
      fs::exists(batch.output(index), problem) ? read_file(batch.output(index)) : std::string();
  if (text.size() > longest) text.erase(0, text.size() - longest);
  while (text.ends_with('\n')) text.pop_back();
  std::ofstream log(directory.log(), std::ios::app);
  log << fmt::format(
      "array task {}_{} left Slurm's queue without a word of this job; it said: {}\n",
      batch.slurm_id ? batch.slurm_id->number : 0, index, text.empty() ? "nothing" : text);
}

manager::WorkerEnd worker_end(std::int64_t job, const job_folder::AttemptEnded& ended) {
  manager::WorkerEnd end;
  end.job = job;
  // An array task notes a worker that died of a signal as shells do.
  constexpr int signal_base = 128;
  if (ended.exit_code > signal_base)
    end.signal = ended.exit_code - signal_base;
  else
    end.exit_code = ended.exit_code;
  end.core_seconds = ended.core_seconds;
  end.peak_memory_bytes = ended.peak_memory_bytes;
  return end;
}

manager::WorkerEnd plain_end(std::int64_t job, int exit_code) {
  manager::WorkerEnd end;
  end.job = job;
  end.exit_code = exit_code;
  return end;
}

}  // namespace

LiveBatch::LiveBatch(Batch batch, bool started_here, std::chrono::seconds grace)
    : batch_(std::move(batch)),
      started_here_(started_here),
      ever_seen_(batch_.slurm_id.has_value()),
      listed_at_the_latest_(std::chrono::steady_clock::now() + grace),
      released_(read_released(batch_)),
      released_noted_(released_.size()) {
  for (const std::vector<BatchJob>& pack : batch_.array) {
    ArrayTask& task = array_.emplace_back();
    for (const BatchJob& job : pack) task.jobs.push_back({job, released_.contains(job.job)});
  }
}

void LiveBatch::note_slurm_id(const SlurmJobId& id) {
  ever_seen_ = true;
  install_slurm_id(batch_, id);
}

bool LiveBatch::over() const {
  return std::ranges::all_of(
      array_, [](const ArrayTask& task) { return std::ranges::all_of(task.jobs, &Job::over); });
}

std::size_t LiveBatch::array_tasks_left() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(array_, [](const ArrayTask& task) { return !task.gone; }));
}

void LiveBatch::see(const QueuedArray* queued) {
  if (queued != nullptr) ever_seen_ = listed_ = true;
  const bool may_be_late = !listed_ && std::chrono::steady_clock::now() < listed_at_the_latest_;
  for (std::size_t k = 0; k < array_.size(); ++k) {
    ArrayTask& task = array_[k];
    const int index = static_cast<int>(k);
    if (queued != nullptr && queued->contains(index)) {
      const auto state = queued->states.find(index);
      task.absences = 0;
      task.gone = false;
      task.pending = state != queued->states.end() && state->second == "PENDING";
    } else {
      task.pending = false;
      if (may_be_late) continue;
      task.gone = ++task.absences >= (ever_seen_ ? absences_of_the_gone : absences_of_the_unknown);
    }
  }
}

bool LiveBatch::newer(const fs::path& file) const {
  std::error_code problem;
  const auto written = fs::last_write_time(file, problem);
  return !problem && written >= batch_.submitted;
}

std::optional<manager::WorkerEnd> LiveBatch::end_of(const ArrayTask& task, int index,
                                                    Job& job) const {
  const job_folder::JobDirectory& directory = job.place.directory;
  if (task.gone) look_again(directory.path);
  // ended.json is written last, so it is read first.
  const auto ended = newer(directory.ended()) ? job_folder::read_ended(directory) : std::nullopt;
  if (ended) look_again(directory.path);
  std::error_code ignored;
  const bool result = fs::exists(directory.result(), ignored);
  if (result || newer(directory.failure())) {
    if (ended) return worker_end(job.place.job, *ended);
    if (task.gone || job.outcome_seen)
      return plain_end(job.place.job,
                       static_cast<int>(result ? ExitCode::done : ExitCode::job_failed));
    job.outcome_seen = true;  // its worker is about to end: what it cost will be known
    return std::nullopt;
  }
  const bool stopping = job.stopping || newer(directory.stop());
  // A worker that was preempted left a checkpoint, and its array task will start again.
  const bool goes_on =
      ended && ended->exit_code == job_folder::worker_stopped && !stopping && !task.gone;
  if (ended && !goes_on) return worker_end(job.place.job, *ended);
  if (!task.gone) return std::nullopt;
  if (stopping || !ever_seen_) return plain_end(job.place.job, job_folder::worker_stopped);
  explain_loss(batch_, index, directory);
  manager::WorkerEnd end;
  end.job = job.place.job;
  end.lost = true;
  return end;
}

std::vector<manager::WorkerEnd> LiveBatch::newly_over(bool queue_known) {
  std::vector<manager::WorkerEnd> ends;
  for (std::size_t k = 0; k < array_.size(); ++k) {
    ArrayTask& task = array_[k];
    if (task.pending && queue_known && !task.gone) continue;  // nobody has written anything
    for (Job& job : task.jobs) {
      if (job.over) continue;
      const auto end = end_of(task, static_cast<int>(k), job);
      if (!end) continue;
      job.over = true;
      // A requeued array task must not take up again what was handed back. (It skips results.)
      std::error_code ignored;
      if (!task.gone && !fs::exists(job.place.directory.result(), ignored))
        released_.insert(job.place.job);
      ends.push_back(*end);
    }
  }
  note_released();
  return ends;
}

void LiveBatch::note_released() {
  if (released_.size() == released_noted_) return;
  try {
    install_released(batch_, released_);
    released_noted_ = released_.size();
  } catch (const EnvironmentError&) {
    // The ends of jobs are not to be lost over this; the next round tries again.
  }
}

void LiveBatch::stop(const std::unordered_set<std::string>& directories, manager::StopKind kind) {
  for (ArrayTask& task : array_) {
    bool any = false;
    for (Job& job : task.jobs) {
      if (job.over || !directories.contains(job.place.directory.path.string())) continue;
      any = job.stopping = true;
      std::ofstream(job.place.directory.stop(), std::ios::app);  // empty, so whole at once
    }
    if (any && std::ranges::all_of(task.jobs, [](const Job& j) { return j.over || j.stopping; }))
      task.cancel = kind;
  }
}

std::vector<int> LiveBatch::to_cancel(manager::StopKind kind) const {
  std::vector<int> indices;
  for (std::size_t k = 0; k < array_.size(); ++k) {
    const ArrayTask& task = array_[k];
    // Of one that has left the queue scancel would say that there is no such job.
    const bool there = task.absences == 0 && (task.pending || kind == manager::StopKind::at_once);
    if (task.cancel == kind && there) indices.push_back(static_cast<int>(k));
  }
  return indices;
}

void LiveBatch::cancelled(const std::vector<int>& indices) {
  for (const int k : indices) array_[static_cast<std::size_t>(k)].cancel.reset();
}

}  // namespace eerie::slurm
