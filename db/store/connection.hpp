#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "db/store/place.hpp"

namespace SQLite {
class Database;
}

namespace eerie::db {

class WithoutLog;

enum class Access {
  read,      ///< the file must exist and have this program's schema
  read_any,  ///< the file must exist; its schema may be older
  write,     ///< the file is created where missing and brought to this program's schema
};

/// One open database: WAL, foreign keys on, a busy timeout instead of "database is locked".
/// SQLite's own exceptions leave as db::Error, with the path in front. For reading a database may
/// lie where nothing can be written (WithoutLog).
class Connection {
 public:
  Connection(std::filesystem::path path, Access access);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Of the file itself, where it was named by a symbolic link.
  const std::filesystem::path& path() const { return path_; }

  /// How long to wait where another program is writing, before BusyError: 10 s at first.
  void wait_at_most(std::chrono::milliseconds patience);

  /// Throws GoneError where the file under this name is another than was opened, or none.
  void require_in_place() const;

  /// Runs `body` on one consistent view of the database.
  void read(const std::function<void(SQLite::Database&)>& body) const;

  /// Runs `body` inside BEGIN IMMEDIATE ... COMMIT; an exception rolls all of it back.
  void write(const std::function<void(SQLite::Database&)>& body);

  /// "ok", or SQLite's first complaint about the file.
  std::string integrity() const;

 private:
  void open(Access access);

  std::filesystem::path path_;
  std::optional<FileIdentity> identity_;
  std::unique_ptr<WithoutLog> without_log_;  ///< outlives the database
  std::unique_ptr<SQLite::Database> database_;
};

}  // namespace eerie::db
