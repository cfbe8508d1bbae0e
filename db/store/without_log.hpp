#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <memory>

namespace eerie::db {

/// A database for reading where SQLite cannot create its log and the index of the log: on a
/// read-only disk or folder, or among files of another user. A file without a log is read directly.
/// With a log, a copy of both in a temporary folder is read. Either way the reader sees the state
/// at the time of opening, and nothing that a manager writes later.
class WithoutLog {
 public:
  /// Opens the database. Throws SQLite::Exception, or Error where no complete copy can be made.
  explicit WithoutLog(const std::filesystem::path& path);
  ~WithoutLog();
  WithoutLog(const WithoutLog&) = delete;
  WithoutLog& operator=(const WithoutLog&) = delete;

  /// May be called once.
  std::unique_ptr<SQLite::Database> database() { return std::move(database_); }

 private:
  std::filesystem::path copies_;  ///< folder of the copies; empty where there are none
  std::unique_ptr<SQLite::Database> database_;
};

}  // namespace eerie::db
