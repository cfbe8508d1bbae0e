#include "db/store/lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <mutex>
#include <string_view>
#include <thread>
#include <vector>

#include "db/store/error.hpp"
#include "db/store/file_system.hpp"

namespace eerie::db {
namespace fs = std::filesystem;

namespace {

fs::path lock_path(const fs::path& database) { return database.string() + ".lock"; }

std::string host_name() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "an unknown host";
  return name.data();
}

std::string content(int descriptor) {
  std::array<char, 512> buffer{};
  const ssize_t length = ::pread(descriptor, buffer.data(), buffer.size(), 0);
  // Between a holder's flock and its note the file is empty for a moment.
  return length > 0 ? std::string(buffer.data(), static_cast<std::size_t>(length))
                    : std::string("a process that has just started");
}

void require_short_name(const fs::path& database) {
  constexpr std::size_t longest = NAME_MAX - 16;  // ".status.json" and others stand behind it
  if (database.filename().string().size() > longest)
    throw Error(fmt::format("database {}: its name is longer than {} bytes; choose a shorter one",
                            database.string(), longest));
}

/// Refuses what is no database before a lock lies beside it. After a power cut a database may have
/// no header until SQLite has read its log.
void require_database(int descriptor, const fs::path& path) {
  std::error_code ignored;
  for (const char* log : {"-wal", "-journal"})
    if (fs::exists(path.string() + log, ignored)) return;
  constexpr std::string_view header{"SQLite format 3\0", 16};
  std::array<char, header.size()> begin{};
  const ssize_t length = ::pread(descriptor, begin.data(), begin.size(), 0);
  if (length > 0 && std::string_view(begin.data(), static_cast<std::size_t>(length)) != header)
    throw Error(fmt::format("database {}: it is not an SQLite database: give another file to --db",
                            path.string()));
}

/// Database files that this process has opened to lock them. They stay open: closing any
/// descriptor of a file drops every POSIX lock of this process on it, SQLite's among them.
class LockedFiles {
 public:
  /// False where somebody, this process included, holds it.
  bool take(const fs::path& database, FileIdentity& which) {
    const std::lock_guard guard(mutex_);
    const auto known = identity(database);
    auto file = std::ranges::find(files_, known, &File::identity);
    if (!known || file == files_.end()) {
      files_.push_back(opened(database));
      file = std::prev(files_.end());
      require_database(file->descriptor, database);
    }
    if (file->held || ::flock(file->descriptor, LOCK_EX | LOCK_NB) != 0) return false;
    file->held = true;
    which = *file->identity;
    return true;
  }

  void let_go(const FileIdentity& which) {
    const std::lock_guard guard(mutex_);
    for (File& file : files_)
      if (file.identity == which) {
        ::flock(file.descriptor, LOCK_UN);
        file.held = false;
      }
  }

 private:
  struct File {
    std::optional<FileIdentity> identity;
    int descriptor = -1;
    bool held = false;
  };

  static File opened(const fs::path& database) {
    const int descriptor = ::open(database.c_str(), O_RDONLY | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor < 0)
      throw Error(
          fmt::format("database {}: cannot open it: {}; check that its folder exists and "
                      "may be written to",
                      database.string(), std::strerror(errno)));
    struct stat info {};
    ::fstat(descriptor, &info);
    return {FileIdentity{info.st_dev, info.st_ino}, descriptor};
  }

  std::mutex mutex_;
  std::vector<File> files_;
};

LockedFiles& locked_files() {
  static LockedFiles files;
  return files;
}

std::string note_of_this_process() {
  return fmt::format(
      "process {} on host {} since {:%FT%TZ}", ::getpid(), host_name(),
      fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

}  // namespace

Lock::Lock(const fs::path& named, std::chrono::milliseconds patience) {
  const fs::path database = resolved(named);
  require_local_disk(database);
  require_short_name(database);
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (!take(database)) {
    if (std::chrono::steady_clock::now() > deadline)
      throw LockedError(fmt::format(
          "database {} is being worked on by {}; wait for it, stop it, or give another file to "
          "--db",
          database.string(), lock_holder(database).value_or("a process that has just started")));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

/// Both locks, or neither.
bool Lock::take(const fs::path& database) {
  FileIdentity which;
  if (!locked_files().take(database, which)) return false;
  try {
    if (take_note(lock_path(database))) {
      held_ = which;
      return true;
    }
  } catch (...) {
    locked_files().let_go(which);
    throw;
  }
  locked_files().let_go(which);
  return false;
}

bool Lock::take_note(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0644);
  if (descriptor < 0)
    throw Error(fmt::format("cannot open {}: {}", path.string(), std::strerror(errno)));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    const int reason = errno;
    ::close(descriptor);
    if (reason == EWOULDBLOCK) return false;
    throw Error(fmt::format("cannot lock {}: {}", path.string(), std::strerror(reason)));
  }
  const std::string note = note_of_this_process();
  // The note only serves messages; the lock itself does not depend on it.
  if (::ftruncate(descriptor, 0) != 0 ||
      ::pwrite(descriptor, note.data(), note.size(), 0) != static_cast<ssize_t>(note.size())) {
    const int reason = errno;
    ::close(descriptor);
    throw Error(fmt::format("cannot write {}: {}", path.string(), std::strerror(reason)));
  }
  note_ = descriptor;
  return true;
}

Lock::~Lock() {
  ::close(note_);
  locked_files().let_go(*held_);
}

std::optional<std::string> lock_holder(const fs::path& database) {
  const int descriptor =
      ::open(lock_path(resolved(database)).c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return std::nullopt;
  std::optional<std::string> holder;
  if (::flock(descriptor, LOCK_SH | LOCK_NB) != 0) holder = content(descriptor);
  ::close(descriptor);
  return holder;
}

}  // namespace eerie::db
