#include "db/store/without_log.hpp"

#include <fmt/format.h>
#include <sqlite3.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <array>

#include "db/store/error.hpp"

namespace eerie::db {
namespace fs = std::filesystem;

namespace {

std::string as_uri(const fs::path& path) {
  std::string uri = "file:";
  for (const char c : fs::absolute(path).string())
    if (c == '%' || c == '?' || c == '#')
      uri += fmt::format("%{:02x}", static_cast<unsigned char>(c));
    else
      uri += c;
  return uri + "?immutable=1";
}

/// By which a file that is written while it is copied is known.
std::array<long long, 3> stamp(const fs::path& file) {
  struct stat info {};
  if (::stat(file.c_str(), &info) != 0) return {};
  return {info.st_size, info.st_mtim.tv_sec, info.st_mtim.tv_nsec};
}

fs::path folder_for_copies() {
  std::string name = (fs::temp_directory_path() / "eerie-read-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw Error(fmt::format("cannot make the folder {} for a copy of the database", name));
  return name;
}

/// Copies database and log until neither changed on the way.
void copy_whole(const fs::path& path, const fs::path& log, const fs::path& folder) {
  for (int attempt = 0; attempt < 5; ++attempt) {
    const auto before = std::pair(stamp(path), stamp(log));
    fs::copy_file(path, folder / "copy.sqlite", fs::copy_options::overwrite_existing);
    fs::copy_file(log, folder / "copy.sqlite-wal", fs::copy_options::overwrite_existing);
    if (before == std::pair(stamp(path), stamp(log))) return;
  }
  throw Error(
      fmt::format("database {}: it is being written, and this user may not read its -shm "
                  "file; make that readable",
                  path.string()));
}

}  // namespace

WithoutLog::WithoutLog(const fs::path& path) {
  const fs::path log = path.string() + "-wal";
  std::error_code ignored;
  const auto log_bytes = fs::file_size(log, ignored);
  if (ignored || log_bytes == 0) {
    database_ =
        std::make_unique<SQLite::Database>(as_uri(path), SQLite::OPEN_READONLY | SQLITE_OPEN_URI);
    return;
  }
  copies_ = folder_for_copies();
  try {
    copy_whole(path, log, copies_);
    fs::permissions(copies_ / "copy.sqlite", fs::perms::owner_write, fs::perm_options::add);
    fs::permissions(copies_ / "copy.sqlite-wal", fs::perms::owner_write, fs::perm_options::add);
    database_ = std::make_unique<SQLite::Database>(copies_ / "copy.sqlite", SQLite::OPEN_READWRITE);
  } catch (...) {
    fs::remove_all(copies_, ignored);
    throw;
  }
}

WithoutLog::~WithoutLog() {
  std::error_code ignored;
  if (!copies_.empty()) fs::remove_all(copies_, ignored);
}

}  // namespace eerie::db
