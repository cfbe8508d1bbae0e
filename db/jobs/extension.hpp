#pragma once

#include <cstdint>

#include "db/jobs/rows.hpp"

namespace SQLite {
class Database;
}

namespace eerie::db {

/// Adds the job that goes on with `job` to every sweep that has this, inside a transaction of the
/// caller. A job that exists already, by its hash, joins them.
void add_extension(SQLite::Database& sql, std::int64_t job, const NewJob& later);

}  // namespace eerie::db
