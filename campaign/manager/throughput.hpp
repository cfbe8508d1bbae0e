#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>

#include "campaign/job_folder/job_directory.hpp"
#include "db/views/query.hpp"

namespace eerie::manager {

/// The speed of one core of a desktop machine, for databases without a measurement.
inline constexpr db::Speed assumed_speed{1, 1e6, 0};

/// The speed and the remaining time of a campaign, by particle-steps. Jobs differ in length, so
/// their number would mislead.
class Throughput {
 public:
  using Clock = std::chrono::steady_clock;

  /// `expected_over_done` is the ratio of expected to actual particle-steps of finished jobs; 0
  /// where it is not known.
  Throughput(double expected_left, double expected_over_done);

  /// Sets the work of waiting jobs, counted again.
  void waiting(double expected) { left_not_running_ = expected; }
  void started(std::int64_t job, double expected);
  void progressed(std::int64_t job, const job_folder::WorkerProgress& progress);
  /// Notes that a job no longer runs. With `done` it is done or has failed; otherwise it will start
  /// again.
  void ended(std::int64_t job, bool done);
  void sample(Clock::time_point now);

  double particle_steps_per_s() const;
  /// The remaining time, s; negative while it is not known.
  double eta_s() const;

 private:
  struct Running {
    double expected = 0;  ///< particle-steps of the whole job
    double last = -1;     ///< particle-steps at the newest report; negative before the first
    double fraction = 0;  ///< fraction of the simulated time until its expected end
  };
  struct Sample {
    Clock::time_point at;
    double done;
  };

  double left_not_running_;  ///< expected particle-steps of waiting jobs
  double scale_;             ///< actual over expected particle-steps
  double done_ = 0;          ///< particle-steps that are done
  std::map<std::int64_t, Running> running_;
  std::deque<Sample> samples_;  ///< of the last half minute
};

}  // namespace eerie::manager
