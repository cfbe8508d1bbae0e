#include "db/store/migrations.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <array>
#include <map>

#include "db/store/bind.hpp"
#include "db/store/column_meanings.hpp"
#include "db/store/error.hpp"
#include "db/store/schema/schema_1.hpp"
#include "db/store/schema/schema_2.hpp"
#include "db/store/schema/schema_3.hpp"
#include "db/store/schema/schema_4.hpp"
#include "db/store/schema/schema_5.hpp"
#include "db/store/schema/schema_6.hpp"

namespace eerie::db {
namespace {

constexpr int application_id = 0x65657269;  // "eeri"

constexpr std::array<Migration, 6> steps = {{
    {1, schema_1},
    {2, schema_2},
    {3, schema_3},
    {4, schema_4},
    {5, schema_5},
    {6, schema_6},
}};

int pragma(SQLite::Database& database, const char* name) {
  return database.execAndGet(fmt::format("PRAGMA {}", name)).getInt();
}

/// Fills the table `units` from the one table of columns.
void describe_columns(SQLite::Database& database) {
  database.exec("DELETE FROM units");
  SQLite::Statement columns(database, "SELECT name FROM pragma_table_info(?)");
  SQLite::Statement insert(database, "INSERT INTO units VALUES (?, ?, ?, ?)");
  for (const View view : {View::results, View::remnants, View::maps}) {
    bind_all(columns, name(view_names, view));
    while (columns.executeStep()) {
      const std::string column = columns.getColumn(0).getString();
      const ColumnMeaning* known = meaning_of(view, column);
      if (known == nullptr) continue;
      bind_all(insert, name(view_names, view), column, std::string(known->unit),
               std::string(known->meaning));
      insert.exec();
    }
  }
}

/// An empty database of the newest schema, in memory.
SQLite::Database& fresh() {
  static SQLite::Database database = [] {
    SQLite::Database made(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    for (const Migration& step : steps) made.exec(step.sql);
    return made;
  }();
  return database;
}

}  // namespace

std::span<const Migration> migrations() { return steps; }
int latest_version() { return steps.back().version; }

void require_ours(SQLite::Database& database, const std::string& path) {
  const int tables = database.execAndGet("SELECT count(*) FROM sqlite_master").getInt();
  if (tables > 0 && pragma(database, "application_id") != application_id)
    throw Error(fmt::format(
        "database {}: it is an SQLite database of another program; give another file to --db",
        path));
  if (const int version = schema_version(database); version < 0)
    throw Error(
        fmt::format("database {}: its schema has version {}, which no eerie has written; "
                    "restore a copy",
                    path, version));
  if (const int version = schema_version(database); version > latest_version())
    throw Error(fmt::format(
        "database {}: its schema has version {} and this program knows versions up to {}; "
        "use a newer eerie",
        path, version, latest_version()));
}

int schema_version(SQLite::Database& database) { return pragma(database, "user_version"); }

std::vector<std::string> changed_views(SQLite::Database& database) {
  const auto views = [](SQLite::Database& sql) {
    std::map<std::string, std::string> found;
    SQLite::Statement select(sql, "SELECT name, sql FROM sqlite_master WHERE type = 'view'");
    while (select.executeStep())
      found[select.getColumn(0).getString()] = select.getColumn(1).getString();
    return found;
  };
  const std::map<std::string, std::string> wanted = views(fresh()), present = views(database);
  std::vector<std::string> changed;
  for (const auto& [name, sql] : wanted)
    if (const auto there = present.find(name); there == present.end() || there->second != sql)
      changed.push_back(name);
  return changed;
}

void remake_views(SQLite::Database& database) {
  const std::vector<std::string> changed = changed_views(database);
  SQLite::Statement select(fresh(),
                           "SELECT sql FROM sqlite_master WHERE type = 'view' AND name = ?");
  for (const std::string& view : changed) {
    database.exec(fmt::format("DROP VIEW IF EXISTS \"{}\"", view));
    bind_all(select, view);
    if (select.executeStep()) database.exec(select.getColumn(0).getString());
  }
}

void migrate(SQLite::Database& database) {
  if (schema_version(database) >= latest_version()) return;
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  // Read again: another process may have migrated while this one waited for the write lock.
  const int version = schema_version(database);
  for (const Migration& step : steps) {
    if (step.version <= version) continue;
    database.exec(step.sql);
    database.exec(fmt::format("PRAGMA user_version = {}", step.version));
  }
  describe_columns(database);
  database.exec(fmt::format("PRAGMA application_id = {}", application_id));
  transaction.commit();
}

}  // namespace eerie::db
