#include "campaign/manager/attempts/awake_time.hpp"

#include <algorithm>

#include "campaign/job_folder/heartbeat.hpp"

namespace eerie::manager {

void AwakeTime::look(const job_folder::JobDirectory& directory, Clock::time_point now) {
  using Seconds = std::chrono::duration<double>;
  constexpr double between_beats = Seconds(job_folder::beat_interval).count();
  const auto beat = job_folder::read_beat(directory);
  if (!beat) return;
  // This process may have been halted itself.
  const double passed = looked_ ? std::min(Seconds(now - *looked_).count(), between_beats) : 0.0;
  looked_ = now;
  since_told_s_ += passed;
  if (!beat->awake_s) return;
  since_told_s_ = std::min(since_told_s_, between_beats);
  if (*beat->awake_s == told_s_) return;
  told_s_ = *beat->awake_s;
  since_told_s_ = 0;
}

}  // namespace eerie::manager
