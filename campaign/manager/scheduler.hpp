#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/job_folder/job_directory.hpp"
#include "solver/base/error.hpp"

namespace eerie::manager {

/// A job for a worker. Its directory contains the scene.
struct Task {
  std::int64_t job = 0;  ///< the row of the job in the database
  job_folder::JobDirectory directory;
  double expected_core_seconds = 0;  ///< an estimate, by the measured speed
};

/// The end of a worker's attempt, as its scheduler knows it.
struct WorkerEnd {
  std::int64_t job = 0;
  int exit_code = -1;  ///< -1 where a signal ended it or the code is not known
  int signal = 0;
  std::optional<double> core_seconds = {};
  std::optional<std::int64_t> peak_memory_bytes = {};
  bool lost = false;  ///< whether it vanished for an unknown reason
};

enum class StopKind {
  with_checkpoint,  ///< stops once a checkpoint is written
  at_once,
};

/// Thrown where the scheduler takes no work now and may do so later. The text has the reason.
struct SchedulerUnavailable : EnvironmentError {
  using EnvironmentError::EnvironmentError;
};

/// The place where workers run. The end of a worker is a hint that its directory has changed; only
/// the files say what became of the job.
class Scheduler {
 public:
  virtual ~Scheduler() = default;

  /// The number of jobs that it would take now.
  virtual std::size_t free_slots() = 0;

  /// Starts or queues a worker for each task. Returns their names in the scheduler, in order:
  /// "1234" for a process, "slurm 17_4" for Slurm. Throws SchedulerUnavailable where it has started
  /// none.
  virtual std::vector<std::string> start(std::span<const Task> tasks) = 0;

  /// Whether a worker that an earlier manager started for the task is still running or queued.
  virtual bool holds(const Task& task) = 0;

  /// The workers started here that have ended since the last call. It waits for one at most this
  /// long.
  virtual std::vector<WorkerEnd> wait(std::chrono::milliseconds longest) = 0;

  /// Asks the workers of these tasks to end. wait() reports them once they have ended.
  virtual void stop(std::span<const Task> tasks, StopKind kind) = 0;
};

}  // namespace eerie::manager
