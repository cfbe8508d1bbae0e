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
  std::size_t jobs = 0;   ///< distinct jobs of the sweep
  std::size_t added = 0;  ///< of these, new to the database
};

/// Adds sweep and jobs in one transaction. A job that is there already, by its hash, is joined
/// to the sweep and not added again; the same sweep added twice adds nothing.
AddedSweep add_sweep(Connection& connection, const std::string& name, const std::string& document,
                     std::span<const NewJob> jobs);

/// How many of these hashes the database does not know yet.
std::size_t count_unknown(const Connection& connection, std::span<const NewJob> jobs);

/// add_sweep inside a transaction of the caller.
AddedSweep add_sweep(SQLite::Database& sql, const std::string& name, const std::string& document,
                     std::span<const NewJob> jobs);

struct JobFilter {
  std::optional<std::int64_t> sweep = {};
  std::optional<JobState> state = {};
  Selection selection = {};
};

/// Jobs in the order in which they are to be run: by priority, then the longest first, so that
/// no long job is left for the end.
std::vector<Job> jobs(const Connection& connection, const JobFilter& filter);

/// The jobs to be started next, at most so many: pending ones that nobody paused.
std::vector<Job> next_jobs(const Connection& connection, std::optional<std::int64_t> sweep,
                           std::size_t most);

bool is_member(const Connection& connection, std::int64_t sweep, std::int64_t job);

/// Running jobs that are wanted otherwise.
std::vector<Job> unwanted_jobs(const Connection& connection);

/// How many jobs of a sweep, or of all, are in which state, and the work that is left.
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

/// A worker that was started.
struct Start {
  std::int64_t job = 0;
  std::string host;     ///< of the manager, until the worker tells its own
  std::string worker;   ///< what the scheduler calls it
  std::string version;  ///< of the program
};
/// Workers have started: their jobs are running.
void begin_attempts(Connection& connection, std::span<const Start> starts);

/// The attempt is over and its job goes to `next`, or to cancelled where it was to be pending and
/// a user wants it so; a crash is counted. Closes the open attempt of the job, where there is
/// one: a manager that was killed may have noted none. Returns the job's state.
JobState end_attempt(Connection& connection, std::int64_t job, const AttemptEnd& end,
                     JobState next);

/// end_attempt with the job's result, in one transaction: the job is done.
void finish(Connection& connection, std::int64_t job, const AttemptEnd& end, const Result& result,
            std::span<const Remnant> remnants);

/// finish inside a transaction of the caller.
void finish(SQLite::Database& sql, std::int64_t job, const AttemptEnd& end, const Result& result,
            std::span<const Remnant> remnants);

}  // namespace eerie::db
