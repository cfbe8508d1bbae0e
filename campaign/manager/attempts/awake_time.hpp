#pragma once

#include <chrono>
#include <optional>

#include "campaign/job_folder/job_directory.hpp"

namespace eerie::manager {

/// The time for which the worker of an attempt has been at work. Time in which it was halted
/// (SIGSTOP) or in which the machine slept does not count. The worker itself reports how long it
/// was awake. Since the last heartbeat at most the time between two heartbeats is assumed.
class AwakeTime {
 public:
  using Clock = std::chrono::steady_clock;

  /// Reads the heartbeat. Call it often while the worker runs.
  void look(const job_folder::JobDirectory& directory, Clock::time_point now);
  double seconds() const { return told_s_ + since_told_s_; }

 private:
  std::optional<Clock::time_point> looked_;  ///< empty before the first heartbeat
  double told_s_ = 0, since_told_s_ = 0;
};

}  // namespace eerie::manager
