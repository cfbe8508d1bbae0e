#include "campaign/manager/silence.hpp"

#include <chrono>
#include <nlohmann/json.hpp>

#include "db/jobs/jobs.hpp"

namespace eerie::manager {
namespace {
constexpr double long_s = 120;  // heartbeats come every 5 s
}

std::vector<Silence> silent_jobs(const db::Connection& connection,
                                 const job_folder::JobFolder& folder) {
  const double now =
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  std::vector<Silence> silent;
  for (const db::Job& job : db::jobs(connection, {std::nullopt, db::JobState::running})) {
    const auto beat = job_folder::read_json(folder.of(job.hash).heartbeat());
    if (!beat || !beat->is_object()) continue;  // still in a queue
    const double silence = now - beat->value("unix_time_s", now);
    if (silence > long_s) silent.push_back({job.hash, beat->value("host", ""), silence});
  }
  return silent;
}

}  // namespace eerie::manager
