#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "db/jobs/rows.hpp"
#include "db/jobs/selection.hpp"
#include "db/store/connection.hpp"
#include "db/views/view.hpp"

namespace eerie::db {

/// Conditions on results. An empty condition holds for every result.
struct ResultFilter {
  std::optional<std::int64_t> sweep = {};
  std::optional<double> q = {}, phi_d_deg = {};
  std::optional<Range> v_imp_cm_per_s = {}, theta_imp_deg = {};
  std::optional<std::string> outcome_class = {};
  bool eer_only = false;  ///< requires at least one extremely elongated remnant
  std::optional<std::string> fidelity = {};
  std::optional<std::int64_t> settings = {};  ///< db/jobs/job_settings.hpp
};

/// A row of the view `results`, with the point of the job.
struct ResultRow {
  std::int64_t job = 0;
  std::string hash;
  double q = 0, phi_d_deg = 0, v_imp_cm_per_s = 0, theta_imp_deg = 0, v_over_v_esc = 0;
  std::int64_t particles_per_target = 0, seed = 0;
  double end_time_s = 0;
  std::string fidelity;       ///< empty: settings without a name
  std::int64_t settings = 0;  ///< db/jobs/job_settings.hpp
  std::string scheme;         ///< numerics.scheme
  Result result;
  std::string finished;
  /// Whether another solver version made it than the one that works on the database.
  bool stale = false;
  std::string stale_reason;
};

/// The results that pass a filter, ordered by q, phi_d, v_imp, theta_imp, seed.
std::vector<ResultRow> results(const Connection& connection, const ResultFilter& filter);

/// The results that a query of the view finds, in its order, with every column.
std::vector<ResultRow> selected_results(const Connection& connection, ViewQuery query);

/// The remnants of a job, the most massive first.
std::vector<Remnant> remnants(const Connection& connection, std::int64_t job);

/// The processor time of all attempts at a job, s. Nothing where that of one attempt is not known,
/// because its machine or its manager died with it.
std::optional<double> core_seconds(const Connection& connection, std::int64_t job);

/// The jobs of a sweep by state, the work that is left, and the time that was spent.
struct SweepStatus {
  std::int64_t id = 0;
  std::string name, created;
  std::string label;  ///< the name, or name@2 for the second sweep of this name, and so on
  std::map<JobState, std::int64_t> jobs;
  std::int64_t paused = 0;         ///< number of pending jobs that are paused
  std::int64_t stale = 0;          ///< number of results from another solver version
  double particle_steps_left = 0;  ///< expected, of pending and running jobs
};
std::vector<SweepStatus> sweep_status(const Connection& connection);

/// One cause of failure, with its number of jobs and one example.
struct FailureGroup {
  std::string kind;
  std::int64_t jobs = 0;
  std::string example_hash, example_message;
};
std::vector<FailureGroup> failures(const Connection& connection,
                                   std::optional<std::int64_t> sweep = std::nullopt);

/// The speed over all finished attempts. Numbers are 0 where nothing was measured.
struct Speed {
  double core_seconds = 0, particle_steps = 0;
  double expected_over_done = 0;  ///< expected over actual particle-steps of finished jobs

  bool is_measured() const { return core_seconds > 0 && particle_steps > 0; }
  /// Actual particle-steps per second. The speed must be measured.
  double particle_steps_per_core_second() const { return particle_steps / core_seconds; }
  /// The core-seconds that expected particle-steps cost. The speed must be measured.
  double core_seconds_of(double expected) const {
    const double real = expected_over_done > 0 ? expected / expected_over_done : expected;
    return real / particle_steps_per_core_second();
  }
};
Speed speed(const Connection& connection);

/// One attempt at a job.
struct AttemptRow {
  std::string host, worker, version, started, ended, exit_reason, failure_kind, message;
  std::optional<double> core_seconds = {}, particle_steps = {};
  std::optional<std::int64_t> peak_memory_bytes = {};
};
std::vector<AttemptRow> attempts(const Connection& connection, std::int64_t job);

/// The labels of the sweeps to which a job belongs.
std::vector<std::string> sweeps_of(const Connection& connection, std::int64_t job);

/// The time when the newest result of the sweep was committed, in seconds since 1970; 0 without
/// results.
double newest_result(const Connection& connection, std::int64_t sweep);

}  // namespace eerie::db
