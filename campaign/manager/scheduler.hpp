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

/// A job for a worker; its directory holds the scene.
struct Task {
  std::int64_t job = 0;  ///< row of the database
  job_folder::JobDirectory directory;
  double expected_core_seconds = 0;  ///< an estimate, at the speed measured so far
};

/// How a worker's attempt ended, as far as its scheduler knows.
struct WorkerEnd {
  std::int64_t job = 0;
  int exit_code = -1;  ///< -1 where a signal ended it, or nobody knows
  int signal = 0;
  std::optional<double> core_seconds = {};
  std::optional<std::int64_t> peak_memory_bytes = {};
  bool lost = false;  ///< it is gone and nobody saw how
};

enum class StopKind {
  with_checkpoint,  ///< as soon as one is written
  at_once,
};

/// The scheduler takes no work now, which time may mend; the text says why.
struct SchedulerUnavailable : EnvironmentError {
  using EnvironmentError::EnvironmentError;
};

/// Where workers run. The end of a worker is a hint that its directory holds news; what became
/// of the job stands in the files alone.
class Scheduler {
 public:
  virtual ~Scheduler() = default;

  /// How many jobs it would take now.
  virtual std::size_t free_slots() = 0;

  /// Starts a worker for each task, or queues one. Returns by what name each is known, in order
  /// ("1234", a process; "slurm 17_4"). Throws SchedulerUnavailable: none was started.
  virtual std::vector<std::string> start(std::span<const Task> tasks) = 0;

  /// Whether a worker that an earlier manager started is still at work on the task, or queued.
  virtual bool holds(const Task& task) = 0;

  /// Workers started here that ended since the last call; waits for one at most this long.
  virtual std::vector<WorkerEnd> wait(std::chrono::milliseconds longest) = 0;

  /// Tells the workers of these tasks to end; wait() reports them when they have.
  virtual void stop(std::span<const Task> tasks, StopKind kind) = 0;
};

}  // namespace eerie::manager
