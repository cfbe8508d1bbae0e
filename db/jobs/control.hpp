#pragma once

#include <functional>
#include <optional>
#include <string>

#include "db/jobs/selection.hpp"
#include "db/store/connection.hpp"

namespace eerie::db {

// The requests of a user about jobs. Each function runs inside a transaction of the caller and
// returns the number of jobs that it changed.

/// Pauses jobs. Waiting ones do not start; running ones stop with a checkpoint.
std::size_t pause(SQLite::Database& sql, const Selection& selection);
/// Lets paused jobs continue.
std::size_t resume(SQLite::Database& sql, const Selection& selection);
/// Cancels jobs without a result, until they are retried. Running ones stop.
std::size_t cancel(SQLite::Database& sql, const Selection& selection);
/// Makes failed and cancelled jobs pending again and forgets their failures.
std::size_t retry(SQLite::Database& sql, const Selection& selection);
/// Retries the failed jobs of this sweep, in a transaction of its own.
std::size_t retry_failed(Connection& connection, std::int64_t sweep);
/// Makes jobs pending again whose result comes from another solver version. The old result stays
/// until there is a new one.
std::size_t rerun_stale(SQLite::Database& sql, const Selection& selection);
std::size_t set_priority(SQLite::Database& sql, const Selection& selection, int priority);
/// Limits the wall time of jobs from now on, s; nothing means no limit. It leaves out jobs that are
/// done.
std::size_t set_wall_limit(SQLite::Database& sql, const Selection& selection,
                           std::optional<double> limit_s);

/// Gives this priority and wall limit, where given, to the jobs of a sweep that were never tried.
void prepare_new_jobs(SQLite::Database& sql, std::int64_t sweep, std::optional<int> priority,
                      std::optional<double> wall_limit_s);

/// Runs `body` and stores its answer under the id of the request, in one transaction. A request
/// runs only once; a repetition returns the stored answer.
std::string once(Connection& connection, const std::string& id, const std::string& kind,
                 const std::function<std::string(SQLite::Database&)>& body);

/// The answer to a request; nothing until it was carried out.
std::optional<std::string> answer(const Connection& connection, const std::string& id);

}  // namespace eerie::db
