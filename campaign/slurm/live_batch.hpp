#pragma once

#include <chrono>
#include <optional>
#include <unordered_set>

#include "campaign/manager/scheduler.hpp"
#include "campaign/slurm/batch.hpp"
#include "campaign/slurm/queue_text.hpp"

namespace eerie::slurm {

/// A batch that is not over, and what was seen of it. Concludes from files what became of a job,
/// and from the queue only that nobody works on it any more.
class LiveBatch {
 public:
  struct Job {
    BatchJob place;
    bool over = false;
    bool stopping = false;      ///< we asked for it
    bool outcome_seen = false;  ///< result or failure is there, ended.json not yet
  };
  struct ArrayTask {
    std::vector<Job> jobs;
    int absences = 0;  ///< successive answers of squeue without it
    bool gone = false;
    bool pending = true;
    std::optional<manager::StopKind> cancel = {};  ///< still to be said to Slurm
  };

  /// Of a submission just made, or of one that another manager left behind. For as long as `grace`,
  /// and until squeue lists it, an answer of squeue without it means nothing: controllers answer
  /// from caches, and copies of them from older ones.
  LiveBatch(Batch batch, bool started_here, std::chrono::seconds grace);

  const Batch& batch() const { return batch_; }
  const std::vector<ArrayTask>& array() const { return array_; }
  bool started_here() const { return started_here_; }
  bool over() const;
  std::size_t array_tasks_left() const;

  void note_slurm_id(const SlurmJobId& id);

  /// Takes an answer of squeue: what it says of this batch, or nullptr where that is nothing.
  void see(const QueuedArray* queued);

  /// Jobs that are over since the last call, as their files tell. `queue_known`: whether the last
  /// question to squeue was answered.
  std::vector<manager::WorkerEnd> newly_over(bool queue_known);

  /// Leaves a stop file for each job of this batch in one of these directories.
  void stop(const std::unordered_set<std::string>& directories, manager::StopKind kind);

  /// Array tasks that Slurm still has to be told to cancel, by index: with_checkpoint those that
  /// wait, for a stop file reaches the others; at_once all that the queue holds.
  std::vector<int> to_cancel(manager::StopKind kind) const;
  void cancelled(const std::vector<int>& indices);

 private:
  std::optional<manager::WorkerEnd> end_of(const ArrayTask& task, int index, Job& job) const;
  void note_released();
  bool newer(const std::filesystem::path& file) const;

  Batch batch_;
  bool started_here_;
  bool ever_seen_;       ///< Slurm has certainly known it
  bool listed_ = false;  ///< squeue has answered with it
  std::chrono::steady_clock::time_point listed_at_the_latest_;
  std::vector<ArrayTask> array_;
  std::set<std::int64_t> released_;
  std::size_t released_noted_;  ///< how many of them stand in the file
};

}  // namespace eerie::slurm
