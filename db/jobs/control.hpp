#pragma once

#include <functional>
#include <optional>
#include <string>

#include "db/jobs/selection.hpp"
#include "db/store/connection.hpp"

namespace eerie::db {

// What a user asks of jobs. Each function runs inside a transaction of the caller and returns how
// many jobs it changed.

/// Jobs that wait do not start; running ones are stopped, with a checkpoint.
std::size_t pause(SQLite::Database& sql, const Selection& selection);
/// Paused jobs go on.
std::size_t resume(SQLite::Database& sql, const Selection& selection);
/// Jobs without a result are given up until they are retried; running ones are stopped.
std::size_t cancel(SQLite::Database& sql, const Selection& selection);
/// Failed and cancelled jobs are pending again, with a clean slate.
std::size_t retry(SQLite::Database& sql, const Selection& selection);
/// Failed jobs of this very sweep alone; in a transaction of its own.
std::size_t retry_failed(Connection& connection, std::int64_t sweep);
/// Jobs whose result an other solver version made are pending again; the old result stays until
/// there is a new one.
std::size_t rerun_stale(SQLite::Database& sql, const Selection& selection);
std::size_t set_priority(SQLite::Database& sql, const Selection& selection, int priority);
/// Wall time that a job may take from now on, s; nothing: no limit. Not of jobs that are done.
std::size_t set_wall_limit(SQLite::Database& sql, const Selection& selection,
                           std::optional<double> limit_s);

/// Jobs of a sweep that were never tried get this priority and wall limit, where they are given.
void prepare_new_jobs(SQLite::Database& sql, std::int64_t sweep, std::optional<int> priority,
                      std::optional<double> wall_limit_s);

/// Runs `body` and notes its answer under the request's id, in one transaction; a request that
/// was carried out already is not again. Returns the answer of the one time.
std::string once(Connection& connection, const std::string& id, const std::string& kind,
                 const std::function<std::string(SQLite::Database&)>& body);

/// The answer to a request, once it was carried out.
std::optional<std::string> answer(const Connection& connection, const std::string& id);

}  // namespace eerie::db
