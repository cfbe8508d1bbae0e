#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <memory>

namespace eerie::db {

/// A database for reading where SQLite cannot make its log and the index of that beside it: a
/// read-only disk or folder, or files of another user. Without a log the file is read as it is;
/// with one, a copy of both in a folder of its own is. Either way it is the state at the time of
/// opening: what a manager writes later is not seen.
class WithoutLog {
 public:
  /// Throws SQLite::Exception, or Error where no whole copy can be made.
  explicit WithoutLog(const std::filesystem::path& path);
  ~WithoutLog();
  WithoutLog(const WithoutLog&) = delete;
  WithoutLog& operator=(const WithoutLog&) = delete;

  /// May be called once.
  std::unique_ptr<SQLite::Database> database() { return std::move(database_); }

 private:
  std::filesystem::path copies_;  ///< folder; empty: there are none
  std::unique_ptr<SQLite::Database> database_;
};

}  // namespace eerie::db
