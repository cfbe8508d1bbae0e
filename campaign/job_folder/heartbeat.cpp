#include "campaign/job_folder/heartbeat.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "campaign/job_folder/provenance.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::job_folder {
using nlohmann::json;

Heartbeat::Heartbeat(std::filesystem::path path, std::chrono::milliseconds interval)
    : path_(std::move(path)), interval_(interval), thread_([this] { beat(); }) {}

Heartbeat::~Heartbeat() {
  {
    const std::lock_guard guard(mutex_);
    over_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Heartbeat::beat() {
  using Clock = std::chrono::steady_clock;
  std::unique_lock guard(mutex_);
  auto last = Clock::now();
  install();
  while (!over_) {
    wake_.wait_for(guard, interval_, [this] { return over_; });
    // A process that was halted, on a machine that may have slept, wakes up late.
    const std::chrono::duration<double> longest = 1.5 * interval_;
    const auto now = Clock::now();
    awake_ += std::min<std::chrono::duration<double>>(now - last, longest);
    last = now;
    install();
  }
}

void Heartbeat::install() const {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const json beat = {{"host", host_name()},
                     {"pid", ::getpid()},
                     {"unix_time_s", std::chrono::duration<double>(now).count()},
                     {"awake_s", awake_.count()}};
  try {
    show_text(path_, beat.dump());
  } catch (const EnvironmentError& error) {
    spdlog::warn("no heartbeat: {}", error.what());  // the run itself may still succeed
  }
}

std::optional<Beat> read_beat(const JobDirectory& directory) {
  const auto document = read_json(directory.heartbeat());
  if (!document || !document->is_object()) return std::nullopt;
  Beat beat;
  try {
    beat.host = document->value("host", "");
    beat.pid = document->value("pid", 0L);
    beat.unix_time_s = document->value("unix_time_s", 0.0);
    if (document->contains("awake_s")) beat.awake_s = document->at("awake_s").get<double>();
  } catch (const json::exception&) {  // a field of another type means a foreign file
    return std::nullopt;
  }
  return beat;
}

}  // namespace eerie::job_folder
