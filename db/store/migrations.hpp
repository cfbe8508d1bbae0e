#pragma once

#include <span>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace eerie::db {

/// One step of the schema. New steps are appended only. A database of an older version takes the
/// remaining steps in order.
struct Migration {
  int version;
  const char* sql;
};

std::span<const Migration> migrations();
int latest_version();

/// Throws Error for a file of another program and for a schema newer than this program's.
void require_ours(SQLite::Database& database, const std::string& path);

/// The version of a database's schema; 0 where it has none yet.
int schema_version(SQLite::Database& database);

/// Names of the views that are missing or other than those of the newest schema. Views hold no
/// data.
std::vector<std::string> changed_views(SQLite::Database& database);
/// Makes those views anew.
void remake_views(SQLite::Database& database);

/// Brings the schema from any version to the newest, in one transaction.
void migrate(SQLite::Database& database);

}  // namespace eerie::db
