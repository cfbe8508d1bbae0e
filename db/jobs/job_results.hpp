#pragma once

#include <cstdint>
#include <span>

#include "db/jobs/rows.hpp"
#include "db/store/connection.hpp"

namespace SQLite {
class Database;
}

namespace eerie::db {

// Results and remnants of a job, inside a transaction of the caller; what was there is replaced.
void insert_result(SQLite::Database& sql, std::int64_t job, const Result& result);
void insert_remnants(SQLite::Database& sql, std::int64_t job, std::span<const Remnant> remnants);

/// What the analysis found, anew: the run that it is about, its cost and the moment when it was
/// finished stay as they are.
void replace_analysis(Connection& connection, std::int64_t job, const Result& result,
                      std::span<const Remnant> remnants);

}  // namespace eerie::db
