#include "db/store/connection.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/statvfs.h>

#include <cstdio>

#include "db/store/error.hpp"
#include "db/store/file_system.hpp"
#include "db/store/migrations.hpp"
#include "db/store/upgrade.hpp"
#include "db/store/without_log.hpp"
#include "solver/base/text/shell_word.hpp"

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
    case SQLITE_IOERR:
      return "; the disk fails, a quota is used up, or files may not be larger (ulimit -f)";
    case SQLITE_ERROR:
      return "; `eerie doctor` tells whether somebody has changed its tables or views";
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

[[noreturn]] void rethrow(const fs::path& path, const SQLite::Exception& error) {
  const int code = error.getErrorCode();
  const std::string text =
      fmt::format("database {}: {}{}", path.string(), error.what(), mend(code));
  // Where the index of the write-ahead log finds no room SQLite speaks of an I/O error.
  if (code == SQLITE_FULL || (code == SQLITE_IOERR && has_little_room(path))) throw FullError(text);
  if (code == SQLITE_BUSY) throw BusyError(text);
  for (const int temporary : {SQLITE_IOERR, SQLITE_READONLY, SQLITE_CANTOPEN, SQLITE_PERM,
                              SQLITE_NOMEM, SQLITE_PROTOCOL, SQLITE_LOCKED})
    if (code == temporary) throw TemporaryError(text);
  throw Error(text);
}

void translated(const fs::path& path, const std::function<void()>& body) {
  try {
    body();
  } catch (const SQLite::Exception& error) {
    rethrow(path, error);
  }
}

void require_openable(const fs::path& path, Access access) {
  std::error_code ignored;
  if (access != Access::write && !fs::exists(path, ignored))
    throw Error(
        fmt::format("database {}: there is no such file; `eerie run SWEEP --db {}` makes it",
                    path.string(), shell_word(path.string())));
  require_local_disk(path);
}

bool lacks_room_for_log(const SQLite::Exception& error) {
  return error.getErrorCode() == SQLITE_CANTOPEN || error.getErrorCode() == SQLITE_READONLY;
}

/// Once in a process, for whoever reads the answer.
void say_what_is_read(const fs::path& path) {
  static const bool once = [&] {
    const std::string text = fmt::format(
        "note: {} lies where this user cannot write: it is read as it is now, and what a manager "
        "writes meanwhile is not seen\n",
        path.string());
    std::fputs(text.c_str(), stderr);
    return true;
  }();
  static_cast<void>(once);
}

/// Throws Error where there is nothing to read yet.
bool is_older(SQLite::Database& database, const fs::path& path) {
  const int version = schema_version(database);
  if (version == 0)
    throw Error(fmt::format("database {}: it is empty; `eerie run SWEEP --db {}` fills it",
                            path.string(), shell_word(path.string())));
  return version < latest_version();
}

void bring_up_to_date(SQLite::Database& database, const fs::path& path) {
  const int version = schema_version(database);
  if (version == latest_version()) return;
  const fs::path kept = version > 0 ? keep_copy(database, path) : fs::path();
  migrate(database);
  if (kept.empty()) return;
  const std::string text = fmt::format(
      "note: {} had schema {} of an older eerie and has schema {} now; as it was, it is kept as "
      "{}\n",
      path.string(), version, latest_version(), kept.string());
  std::fputs(text.c_str(), stderr);
}

}  // namespace

Connection::Connection(fs::path path, Access access) : path_(resolved(path)) {
  require_openable(path_, access);
  translated(path_, [&] {
    try {
      open(access);
    } catch (const SQLite::Exception& error) {
      if (access == Access::write || !lacks_room_for_log(error)) throw;
      database_.reset();
      without_log_ = std::make_unique<WithoutLog>(path_);
      database_ = without_log_->database();
      require_ours(*database_, path_.string());
      say_what_is_read(path_);
    }
    if (access == Access::read && is_older(*database_, path_))
      database_ = upgraded_copy(*database_, path_);
  });
  identity_ = identity(path_);
}

void Connection::open(Access access) {
  const int flags = access == Access::write ? SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE
                                            : SQLite::OPEN_READONLY;
  database_ = std::make_unique<SQLite::Database>(path_.string(), flags, busy_timeout_ms);
  require_ours(*database_, path_.string());
  if (access != Access::write) return;
  // synchronous = FULL: a row that was committed outlives a power cut, also in WAL mode.
  database_->exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
  bring_up_to_date(*database_, path_);
}

Connection::~Connection() = default;

void Connection::wait_at_most(std::chrono::milliseconds patience) {
  database_->setBusyTimeout(static_cast<int>(patience.count()));
}

void Connection::require_in_place() const {
  if (identity(path_) == identity_) return;
  throw GoneError(fmt::format(
      "database {}: the file was removed or another put in its place; put it back, or submit the "
      "sweeps to a new one: results are taken from the job directories",
      path_.string()));
}

void Connection::read(const std::function<void(SQLite::Database&)>& body) const {
  translated(path_, [&] {
    SQLite::Transaction transaction(*database_);
    body(*database_);
    transaction.commit();
  });
}

void Connection::write(const std::function<void(SQLite::Database&)>& body) {
  require_in_place();
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
