#include "campaign/manager/silence.hpp"

#include <chrono>

#include "campaign/job_folder/heartbeat.hpp"
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
    const auto beat = job_folder::read_beat(folder.of(job.hash));
    if (!beat) continue;  // still in a queue
    const double silence = now - beat->unix_time_s;
    if (beat->unix_time_s > 0 && silence > long_s)
      silent.push_back({job.hash, beat->host, silence});
  }
  return silent;
}

}  // namespace eerie::manager
