#pragma once

#include <filesystem>
#include <memory>

namespace SQLite {
class Database;
}

namespace eerie::db {

/// A private copy of a database of an older schema, with this program's schema. The file stays as
/// it is, so that an older program may go on writing to it.
std::unique_ptr<SQLite::Database> upgraded_copy(SQLite::Database& older,
                                                const std::filesystem::path& path);

/// Copies a database of an older schema, as it is, to a file beside it, so that an older program
/// can still be used. Returns its path, "PATH.schema-N". A copy of before is replaced.
std::filesystem::path keep_copy(SQLite::Database& older, const std::filesystem::path& path);

/// The version of the schema of a database's file, which may be older than latest_version().
int schema_of_file(const std::filesystem::path& path);

}  // namespace eerie::db
