#pragma once

#include <chrono>
#include <filesystem>

#include "campaign/process/signals.hpp"

namespace eerie::worker {

/// Says whether a stop was requested, by a signal or, from another host, by the file `stop` in the
/// job directory. It looks for that file once a second.
class StopRequest {
 public:
  explicit StopRequest(std::filesystem::path file) : file_(std::move(file)) {}

  bool operator()() {
    if (process::stop_requests() > 0) return true;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::seconds(1)) return found_;
    last_ = now;
    std::error_code ignored;
    return found_ = std::filesystem::exists(file_, ignored);
  }

 private:
  std::filesystem::path file_;
  std::chrono::steady_clock::time_point last_{};
  bool found_ = false;
};

}  // namespace eerie::worker
