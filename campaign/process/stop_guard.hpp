#pragma once

#include <chrono>
#include <thread>

namespace eerie::process {

/// Ends this process where nobody has looked at a stop request for `longest`: the main thread hangs
/// in a file of somebody else, or in work without end. It says so on standard error and ends with
/// exit code 3, as if it had been killed: what counts is on the disk by then, and workers that lose
/// their manager leave checkpoints.
class StopGuard {
 public:
  explicit StopGuard(std::chrono::milliseconds longest = std::chrono::seconds(10));

 private:
  std::jthread thread_;
};

}  // namespace eerie::process
