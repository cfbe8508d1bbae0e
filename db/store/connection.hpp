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
  read,      ///< the file must exist; of one with an older schema an upgraded copy is read
  read_any,  ///< the file must exist; its schema may be older
  write,     ///< the file is created, or gets this program's schema; as it was, it is kept
};

/// An open database, with WAL and foreign keys. It waits where SQLite would say "database is
/// locked". Exceptions of SQLite leave as db::Error with the path in front. A database for reading
/// may lie where nothing can be written (WithoutLog), or be older than the program (upgrade.hpp).
class Connection {
 public:
  Connection(std::filesystem::path path, Access access);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// The path of the file itself, also where it was named by a symbolic link.
  const std::filesystem::path& path() const { return path_; }

  /// Sets how long a call waits for another writer before it throws BusyError. The initial value is
  /// 10 s.
  void wait_at_most(std::chrono::milliseconds patience);

  /// Throws GoneError where the file under this name is missing or is not the one that was opened.
  void require_in_place() const;

  /// Runs `body` on one consistent state of the database.
  void read(const std::function<void(SQLite::Database&)>& body) const;

  /// Runs `body` inside BEGIN IMMEDIATE ... COMMIT; an exception rolls all of it back.
  void write(const std::function<void(SQLite::Database&)>& body);

  /// SQLite's check of the file: "ok", or its first complaint.
  std::string integrity() const;

 private:
  void open(Access access);

  std::filesystem::path path_;
  std::optional<FileIdentity> identity_;
  std::unique_ptr<WithoutLog> without_log_;  ///< must outlive the database
  std::unique_ptr<SQLite::Database> database_;
};

}  // namespace eerie::db
