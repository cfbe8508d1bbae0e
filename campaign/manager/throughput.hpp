#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>

#include "campaign/job_folder/job_directory.hpp"
#include "db/views/query.hpp"

namespace eerie::manager {

/// Of one core of a desktop machine, where a database has measured nothing yet.
inline constexpr db::Speed assumed_speed{1, 1e6, 0};

/// Speed and time left of a campaign, from particle-steps: jobs differ in length, so counting
/// jobs would mislead.
class Throughput {
 public:
  using Clock = std::chrono::steady_clock;

  /// `expected_over_done`: of finished jobs, how their expected particle-steps compare with the
  /// real ones; 0 where unknown.
  Throughput(double expected_left, double expected_over_done);

  /// The work of jobs that wait, counted anew.
  void waiting(double expected) { left_not_running_ = expected; }
  void started(std::int64_t job, double expected);
  void progressed(std::int64_t job, const job_folder::WorkerProgress& progress);
  /// The job runs no longer; `done`: for good (done or failed), else it will start again.
  void ended(std::int64_t job, bool done);
  void sample(Clock::time_point now);

  double particle_steps_per_s() const;
  /// Seconds, or a negative number while unknown.
  double eta_s() const;

 private:
  struct Running {
    double expected = 0;  ///< particle-steps of the whole job
    double last = -1;     ///< particle-steps at the newest report; negative: none yet
    double fraction = 0;  ///< of the simulated time until it should end
  };
  struct Sample {
    Clock::time_point at;
    double done;
  };

  double left_not_running_;  ///< expected particle-steps of jobs that wait
  double scale_;             ///< real over expected particle-steps
  double done_ = 0;          ///< particle-steps seen to be done
  std::map<std::int64_t, Running> running_;
  std::deque<Sample> samples_;  ///< of the last half minute
};

}  // namespace eerie::manager
