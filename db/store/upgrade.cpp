#include "db/store/upgrade.hpp"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include "db/store/bind.hpp"
#include "db/store/connection.hpp"
#include "db/store/migrations.hpp"
#include "solver/base/file.hpp"

namespace eerie::db {
namespace fs = std::filesystem;

namespace {

void copy_all(SQLite::Database& from, SQLite::Database& to) {
  SQLite::Backup backup(to, from);
  if (const int code = backup.executeStep(); code != SQLITE_DONE)
    throw SQLite::Exception("it cannot be copied now", code);
}

}  // namespace

std::unique_ptr<SQLite::Database> upgraded_copy(SQLite::Database& older, const fs::path& path) {
  // Without a name: in memory, and what finds no room there in a temporary file.
  auto copy = std::make_unique<SQLite::Database>("", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  copy_all(older, *copy);
  migrate(*copy);
  // What a manager would note before it works on the file.
  SQLite::Statement note(*copy, "INSERT OR REPLACE INTO settings VALUES ('database_name', ?)");
  bind_all(note, path.filename().string());
  note.exec();
  return copy;
}

fs::path keep_copy(SQLite::Database& older, const fs::path& path) {
  const fs::path kept = fmt::format("{}.schema-{}", path.string(), schema_version(older));
  install_file(kept, [&](const fs::path& temporary) {
    SQLite::Database copy(temporary.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    copy_all(older, copy);
  });
  return kept;
}

int schema_of_file(const fs::path& path) {
  int version = 0;
  Connection(path, Access::read_any).read([&](SQLite::Database& sql) {
    version = schema_version(sql);
  });
  return version;
}

}  // namespace eerie::db
