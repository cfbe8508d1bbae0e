#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job_directory.hpp"

namespace eerie {

/// How a worker's process ended, as far as its scheduler knows.
struct WorkerEnd {
  std::int64_t job = 0;
  int exit_code = -1;  ///< -1 where a signal ended it
  int signal = 0;
  std::optional<double> core_seconds;
  std::optional<std::int64_t> peak_memory_bytes;
};

/// Where workers run. The end of a process is a hint that its directory holds news; what became
/// of the job stands in the files alone.
class Scheduler {
 public:
  virtual ~Scheduler() = default;
  virtual std::size_t free_slots() const = 0;
  /// Starts a worker in a directory that holds a scene. Returns its process id.
  virtual std::int64_t start(std::int64_t job, const JobDirectory& directory) = 0;
  /// Workers that ended since the last call; waits for one at most this long.
  virtual std::vector<WorkerEnd> wait(std::chrono::milliseconds longest) = 0;
  /// Tells every worker to write a checkpoint and end.
  virtual void stop_all() = 0;
  /// Ends every worker at once, without a checkpoint.
  virtual void kill_all() = 0;
};

}  // namespace eerie
