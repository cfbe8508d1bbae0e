#pragma once

#include <cstdint>
#include <span>

#include "db/jobs/rows.hpp"
#include "db/store/connection.hpp"

namespace SQLite {
class Database;
}

namespace eerie::db {

// These functions store the results and remnants of a job, inside a transaction of the caller, and
// replace earlier ones.
void insert_result(SQLite::Database& sql, std::int64_t job, const Result& result);
void insert_remnants(SQLite::Database& sql, std::int64_t job, std::span<const Remnant> remnants);

/// Replaces what the analysis found. The run, its cost and the time when it finished stay.
void replace_analysis(Connection& connection, std::int64_t job, const Result& result,
                      std::span<const Remnant> remnants);

}  // namespace eerie::db
