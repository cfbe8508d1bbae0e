#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "campaign/job_folder/job_directory.hpp"

namespace eerie::job_folder {

/// The time between two heartbeats of a worker.
inline constexpr std::chrono::milliseconds beat_interval{5000};

/// While it lives, it installs a file every five seconds that names the process and its host, and
/// says for how long it has been awake. It does so also during a long step and while bodies are
/// made, when there is no progress to report.
class Heartbeat {
 public:
  explicit Heartbeat(std::filesystem::path path,
                     std::chrono::milliseconds interval = beat_interval);
  ~Heartbeat();
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;

 private:
  void beat();
  void install() const;

  std::filesystem::path path_;
  std::chrono::milliseconds interval_;
  std::chrono::duration<double> awake_{
      0};  ///< time in which this worker was neither halted nor asleep
  std::mutex mutex_;
  std::condition_variable wake_;
  bool over_ = false;
  std::thread thread_;
};

/// The last heartbeat of a worker.
struct Beat {
  std::string host;
  long pid = 0;
  double unix_time_s = 0;
  std::optional<double> awake_s = {};  ///< nothing for an older worker, which does not report it
};
/// Reads the last heartbeat; nothing where the file is missing or unreadable.
std::optional<Beat> read_beat(const JobDirectory& directory);

}  // namespace eerie::job_folder
