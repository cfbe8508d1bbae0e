#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "db/jobs/rows.hpp"
#include "db/jobs/selection.hpp"
#include "db/store/connection.hpp"

namespace eerie::db {

struct AddedSweep {
  std::int64_t sweep = 0;
  std::size_t jobs = 0;   ///< number of distinct jobs of the sweep
  std::size_t added = 0;  ///< number of these that are new to the database
  /// Its name, or name@2 where it is the second sweep of this name, and so on.
  std::string label = {};
};

/// Adds a sweep and its jobs in one transaction. A job that exists already, by its hash, joins the
/// sweep and is not added again. So adding a sweep twice adds nothing.
AddedSweep add_sweep(Connection& connection, const std::string& name, const std::string& document,
                     std::span<const NewJob> jobs);

/// The number of these hashes that the database does not have yet.
std::size_t count_unknown(const Connection& connection, std::span<const NewJob> jobs);

/// add_sweep() inside a transaction of the caller.
AddedSweep add_sweep(SQLite::Database& sql, const std::string& name, const std::string& document,
                     std::span<const NewJob> jobs);

struct JobFilter {
  std::optional<std::int64_t> sweep = {};
  std::optional<JobState> state = {};
  Selection selection = {};
};

/// Jobs in the order in which they will run: by priority, then the longest first, so that no long
/// job runs alone at the end.
std::vector<Job> jobs(const Connection& connection, const JobFilter& filter);

/// The next jobs to start, at most `most`: pending jobs that nobody has paused.
std::vector<Job> next_jobs(const Connection& connection, std::optional<std::int64_t> sweep,
                           std::size_t most);

bool is_member(const Connection& connection, std::int64_t sweep, std::int64_t job);

/// Running jobs that a user wants to stop.
std::vector<Job> unwanted_jobs(const Connection& connection);

/// The number of jobs of a sweep, or of all, in each state, and the remaining work.
struct JobCounts {
  std::array<std::size_t, job_state_names.size()> in_state = {};
  std::size_t paused = 0;              ///< of the pending ones
  double expected_particle_steps = 0;  ///< of pending jobs that are not paused

  std::size_t operator[](JobState state) const {
    return in_state.at(static_cast<std::size_t>(state));
  }
  std::size_t total() const;
};
JobCounts count_jobs(const Connection& connection, std::optional<std::int64_t> sweep);

std::string scene(const Connection& connection, std::int64_t job);

/// A worker that has started.
struct Start {
  std::int64_t job = 0;
  std::string host;     ///< host of the manager, until the worker tells its own
  std::string worker;   ///< its name in the scheduler
  std::string version;  ///< version of the program
};
/// Notes that workers have started, so their jobs are running.
void begin_attempts(Connection& connection, std::span<const Start> starts);

/// Notes that an attempt has ended. Its job goes to the state `next`; a job that would be pending
/// goes to cancelled where a user wants that. It counts a crash. It closes the open attempt of the
/// job, if there is one, since a killed manager may have noted none. Returns the state of the job.
JobState end_attempt(Connection& connection, std::int64_t job, const AttemptEnd& end,
                     JobState next);

/// Ends an attempt with the result of the job, in one transaction. The job is then done.
void finish(Connection& connection, std::int64_t job, const AttemptEnd& end, const Result& result,
            std::span<const Remnant> remnants);

/// finish() inside a transaction of the caller.
void finish(SQLite::Database& sql, std::int64_t job, const AttemptEnd& end, const Result& result,
            std::span<const Remnant> remnants);

}  // namespace eerie::db
