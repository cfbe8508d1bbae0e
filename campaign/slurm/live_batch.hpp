#pragma once

#include <chrono>
#include <optional>
#include <unordered_set>

#include "campaign/manager/scheduler.hpp"
#include "campaign/slurm/batch.hpp"
#include "campaign/slurm/queue_text.hpp"

namespace eerie::slurm {

/// A batch that is not over, and the observations about it. Files decide what became of a job; the
/// queue only shows that nobody works on it any more.
class LiveBatch {
 public:
  struct Job {
    BatchJob place;
    bool over = false;
    bool stopping = false;      ///< whether this manager has asked it to stop
    bool outcome_seen = false;  ///< whether its result or failure exists, but not yet ended.json
  };
  struct ArrayTask {
    std::vector<Job> jobs;
    int absences = 0;  ///< number of successive answers of squeue without it
    bool gone = false;
    bool pending = true;
    std::optional<manager::StopKind> cancel = {};  ///< a cancellation that Slurm does not know yet
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

  /// Takes what an answer of squeue says about this batch, or nullptr where that is nothing.
  void see(const QueuedArray* queued);

  /// The jobs that have ended since the last call, by their files. `queue_known` says whether
  /// squeue has answered the last question.
  std::vector<manager::WorkerEnd> newly_over(bool queue_known);

  /// Writes a stop file for each job of this batch in one of these directories.
  void stop(const std::unordered_set<std::string>& directories, manager::StopKind kind);

  /// The indices of array tasks that Slurm must still cancel. With with_checkpoint these are the
  /// waiting ones, since a stop file reaches the others; with at_once all that are in the queue.
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
  std::size_t released_noted_;  ///< how many of them are in the file
};

}  // namespace eerie::slurm
