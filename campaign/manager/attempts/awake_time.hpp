#pragma once

#include <chrono>
#include <optional>

#include "campaign/job_folder/job_directory.hpp"

namespace eerie::manager {

/// For how long the worker of an attempt has been at work. What it was halted for (SIGSTOP), and
/// what the machine slept, does not count: the worker itself says how long it was awake, and
/// between two heartbeats no more is assumed than lies between two of them.
class AwakeTime {
 public:
  using Clock = std::chrono::steady_clock;

  /// Reads the heartbeat; called often while the worker is there.
  void look(const job_folder::JobDirectory& directory, Clock::time_point now);
  double seconds() const { return told_s_ + since_told_s_; }

 private:
  std::optional<Clock::time_point> looked_;  ///< empty: no heartbeat was seen yet
  double told_s_ = 0, since_told_s_ = 0;
};

}  // namespace eerie::manager
