#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

namespace eerie::job_folder {

/// While it lives, installs a file every five seconds that says which process is alive where:
/// also during a long step or the making of the bodies, when there is no progress to tell.
class Heartbeat {
 public:
  explicit Heartbeat(std::filesystem::path path);
  ~Heartbeat();
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;

 private:
  void beat();

  std::filesystem::path path_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool over_ = false;
  std::thread thread_;
};

}  // namespace eerie::job_folder
