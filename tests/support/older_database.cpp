#include "tests/support/older_database.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <string>

#include "db/store/migrations.hpp"

namespace eerie::test {

void make_schema_5(const std::filesystem::path& database) {
  SQLite::Database older(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  for (const db::Migration& step : db::migrations())
    if (step.version <= 5) older.exec(step.sql);
  SQLite::Database sql(database.string(), SQLite::OPEN_READWRITE);
  for (const char* view : {"results", "remnants", "maps", "job_folders", "sweep_labels"})
    sql.exec(std::string("DROP VIEW ") + view);
  sql.exec(
      "DROP TABLE units; DROP TRIGGER note_scheme; ALTER TABLE job_settings DROP COLUMN scheme; "
      "DELETE FROM settings WHERE key = 'database_name'");
  SQLite::Statement views(older,
                          "SELECT sql FROM sqlite_master WHERE type = 'view' AND name IN "
                          "('results', 'remnants', 'maps')");
  while (views.executeStep()) sql.exec(views.getColumn(0).getString());
  sql.exec("PRAGMA user_version = 5; PRAGMA wal_checkpoint(TRUNCATE)");
}

}  // namespace eerie::test
