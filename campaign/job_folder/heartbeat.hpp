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

/// How often a worker beats.
inline constexpr std::chrono::milliseconds beat_interval{5000};

/// While it lives, installs a file every five seconds that says which process is alive where, and
/// for how long it has been awake: also during a long step or the making of the bodies, when there
/// is no progress to tell.
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
  std::chrono::duration<double> awake_{0};  ///< of this worker; not halted, not asleep
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
  std::optional<double> awake_s = {};  ///< nothing: an older worker, which did not say
};
/// Nothing where the file is missing or unreadable.
std::optional<Beat> read_beat(const JobDirectory& directory);

}  // namespace eerie::job_folder
