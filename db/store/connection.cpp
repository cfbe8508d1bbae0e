#include "db/store/connection.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/statvfs.h>

#include "db/store/migrations.hpp"
#include "db/store/error.hpp"
#include "db/store/file_system.hpp"

namespace eerie::db {
namespace fs = std::filesystem;

namespace {

constexpr int busy_timeout_ms = 10'000;

/// What SQLite's code means for the person at the keyboard.
const char* mend(int code) {
  switch (code) {
    case SQLITE_NOTADB:
      return "; it is not an SQLite database: give another file to --db";
    case SQLITE_FULL:
      return "; free some disk space and start again";
    case SQLITE_BUSY:
      return "; another program holds it open for writing: close that one";
    case SQLITE_READONLY:
      return "; make the file and its folder writable";
    case SQLITE_CANTOPEN:
      return "; check that its folder exists and may be written to";
    case SQLITE_CORRUPT:
      return "; the file is damaged: restore a copy, the job folders hold every result";
    default:
      return "";
  }
}

bool has_little_room(const fs::path& path) {
  constexpr unsigned long long little = 1 << 16;
  struct statvfs info {};
  return ::statvfs(fs::absolute(path).parent_path().c_str(), &info) == 0 &&
         static_cast<unsigned long long>(info.f_bavail) * info.f_frsize < little;
}

void translated(const fs::path& path, const std::function<void()>& body) {
  try {
    body();
  } catch (const SQLite::Exception& error) {
    const std::string text =
        fmt::format("database {}: {}{}", path.string(), error.what(), mend(error.getErrorCode()));
    // Where the index of the write-ahead log finds no room SQLite speaks of an I/O error.
    if (error.getErrorCode() == SQLITE_FULL ||
        (error.getErrorCode() == SQLITE_IOERR && has_little_room(path)))
      throw FullError(text);
    throw Error(text);
  }
}

void require_openable(const fs::path& path, Access access) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw Error(fmt::format("database {}: it is a folder; give a file to --db", path.string()));
  if (access != Access::write && !fs::exists(path, ignored))
    throw Error(
        fmt::format("database {}: there is no such file; `eerie run SWEEP --db {}` makes it",
                    path.string(), path.string()));
  require_local_disk(path);
}

}  // namespace

Connection::Connection(fs::path path, Access access) : path_(std::move(path)) {
  require_openable(path_, access);
  translated(path_, [&] {
    const int flags = access == Access::write ? SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE
                                              : SQLite::OPEN_READONLY;
    database_ = std::make_unique<SQLite::Database>(path_.string(), flags, busy_timeout_ms);
    require_ours(*database_, path_.string());
    if (access == Access::write) {
      // synchronous = FULL: a row that was committed outlives a power cut, also in WAL mode.
      database_->exec(
          "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
      migrate(*database_);
    } else if (access == Access::read) {
      require_current(*database_, path_.string());
    }
  });
}

Connection::~Connection() = default;

void Connection::read(const std::function<void(SQLite::Database&)>& body) const {
  translated(path_, [&] {
    SQLite::Transaction transaction(*database_);
    body(*database_);
    transaction.commit();
  });
}

void Connection::write(const std::function<void(SQLite::Database&)>& body) {
  translated(path_, [&] {
    SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
    body(*database_);
    transaction.commit();
  });
}

std::string Connection::integrity() const {
  std::string verdict;
  translated(path_,
             [&] { verdict = database_->execAndGet("PRAGMA integrity_check(1)").getString(); });
  return verdict;
}

}  // namespace eerie::db
