#include "campaign/manager/throughput.hpp"

#include <algorithm>

namespace eerie::manager {
namespace {
constexpr auto window = std::chrono::seconds(30);
}

Throughput::Throughput(double expected_left, double expected_over_done)
    : left_not_running_(expected_left),
      scale_(expected_over_done > 0 ? 1 / expected_over_done : 1) {}

void Throughput::started(std::int64_t job, double expected) {
  running_[job] = {expected, -1, 0};
  left_not_running_ -= expected;
}

void Throughput::progressed(std::int64_t job, const job_folder::WorkerProgress& progress) {
  const auto entry = running_.find(job);
  if (entry == running_.end()) return;
  Running& run = entry->second;
  // Fewer than before: what a killed worker said last, and the next one goes on from a checkpoint.
  if (run.last >= 0) done_ += std::max(0.0, progress.particle_steps - run.last);
  run.last = progress.particle_steps;
  if (progress.expected_end_s > 0) run.fraction = progress.time_s / progress.expected_end_s;
}

void Throughput::ended(std::int64_t job, bool done) {
  const auto entry = running_.find(job);
  if (entry == running_.end()) return;
  if (!done) left_not_running_ += entry->second.expected;
  running_.erase(entry);
}

void Throughput::sample(Clock::time_point now) {
  samples_.push_back({now, done_});
  while (samples_.size() > 2 && now - samples_.front().at > window) samples_.pop_front();
}

double Throughput::particle_steps_per_s() const {
  if (samples_.size() < 2) return 0;
  const double seconds =
      std::chrono::duration<double>(samples_.back().at - samples_.front().at).count();
  return seconds > 0 ? (samples_.back().done - samples_.front().done) / seconds : 0;
}

double Throughput::eta_s() const {
  const double speed = particle_steps_per_s();
  if (speed <= 0) return -1;
  double left = left_not_running_ * scale_;
  for (const auto& [job, run] : running_) {
    // A run that has come some way knows its own length better than the formula does; one that
    // should be over by now may go on for a tenth of what it has behind it.
    if (run.fraction > 0.02)
      left += run.last * (run.fraction < 1 ? 1 / run.fraction - 1 : 0.1);
    else
      left += run.expected * scale_ * (1 - run.fraction);
  }
  return std::max(0.0, left / speed);
}

}  // namespace eerie::manager
