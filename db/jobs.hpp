#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "db/connection.hpp"
#include "db/rows.hpp"

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

struct JobFilter {
  std::optional<std::int64_t> sweep = {};
  std::optional<JobState> state = {};
};

/// Jobs in the order in which they are to be run: by priority, then the longest first, so that
/// no long job is left for the end.
std::vector<Job> jobs(const Connection& connection, const JobFilter& filter);

std::string scene(const Connection& connection, std::int64_t job);

/// A worker has started: the job is running. Returns the attempt.
std::int64_t begin_attempt(Connection& connection, std::int64_t job, const std::string& host,
                           std::int64_t pid, const std::string& version);

/// The attempt is over and its job goes to `next`; a crash is counted. Closes an open attempt
/// of the job, where there is one: rows of a manager that was killed have none to name.
void end_attempt(Connection& connection, std::int64_t job, const AttemptEnd& end, JobState next);

/// end_attempt with the job's result, in one transaction: the job is done.
void finish(Connection& connection, std::int64_t job, const AttemptEnd& end, const Result& result,
            std::span<const Remnant> remnants);

/// Failed jobs of a sweep go back to pending with no crashes counted. Returns how many.
std::size_t retry_failed(Connection& connection, std::int64_t sweep);

}  // namespace eerie::db
