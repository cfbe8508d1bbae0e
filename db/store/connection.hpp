#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace SQLite {
class Database;
}

namespace eerie::db {

enum class Access {
  read,      ///< the file must exist and have this program's schema
  read_any,  ///< the file must exist; its schema may be older
  write,     ///< the file is created where missing and brought to this program's schema
};

/// One open database: WAL, foreign keys on, a busy timeout instead of "database is locked".
/// SQLite's own exceptions leave as db::Error, with the path in front.
class Connection {
 public:
  Connection(std::filesystem::path path, Access access);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Runs `body` on one consistent view of the database.
  void read(const std::function<void(SQLite::Database&)>& body) const;

  /// Runs `body` inside BEGIN IMMEDIATE ... COMMIT; an exception rolls all of it back.
  void write(const std::function<void(SQLite::Database&)>& body);

  /// "ok", or SQLite's first complaint about the file.
  std::string integrity() const;

 private:
  std::filesystem::path path_;
  std::unique_ptr<SQLite::Database> database_;
};

}  // namespace eerie::db
