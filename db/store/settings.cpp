#include "db/store/settings.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "db/store/bind.hpp"

namespace eerie::db {

std::optional<std::string> setting(const Connection& connection, const std::string& key) {
  std::optional<std::string> value;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, "SELECT value FROM settings WHERE key = ?");
    bind_all(select, key);
    if (select.executeStep()) value = select.getColumn(0).getString();
  });
  return value;
}

void set(Connection& connection, const std::string& key, const std::string& value) {
  if (setting(connection, key) == value) return;
  connection.write([&](SQLite::Database& sql) {
    SQLite::Statement insert(sql, "INSERT OR REPLACE INTO settings (key, value) VALUES (?, ?)");
    bind_all(insert, key, value);
    insert.exec();
  });
}

}  // namespace eerie::db
