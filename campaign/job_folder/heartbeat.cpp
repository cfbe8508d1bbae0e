#include "campaign/job_folder/heartbeat.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "campaign/job_folder/provenance.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::job_folder {
namespace {

constexpr auto interval = std::chrono::seconds(5);

std::string content() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return nlohmann::json{{"host", host_name()},
                        {"pid", ::getpid()},
                        {"unix_time_s", std::chrono::duration<double>(now).count()}}
      .dump();
}

}  // namespace

Heartbeat::Heartbeat(std::filesystem::path path)
    : path_(std::move(path)), thread_([this] { beat(); }) {}

Heartbeat::~Heartbeat() {
  {
    const std::lock_guard guard(mutex_);
    over_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Heartbeat::beat() {
  std::unique_lock guard(mutex_);
  while (!over_) {
    try {
      install_text(path_, content());
    } catch (const EnvironmentError& error) {
      spdlog::warn("no heartbeat: {}", error.what());  // the run itself may still succeed
    }
    wake_.wait_for(guard, interval, [this] { return over_; });
  }
}

}  // namespace eerie::job_folder
