#include "db/store/lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>

#include "db/store/error.hpp"

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

}  // namespace

Lock::Lock(const fs::path& database) {
  const fs::path path = lock_path(database);
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor_ < 0)
    throw Error(fmt::format("cannot open {}: {}", path.string(), std::strerror(errno)));
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    const int reason = errno;
    const std::string holder = content(descriptor_);
    ::close(descriptor_);
    if (reason != EWOULDBLOCK)
      throw Error(fmt::format("cannot lock {}: {}", path.string(), std::strerror(reason)));
    throw LockedError(fmt::format(
        "database {} is being worked on by {}; wait for it, stop it, or give another file to --db",
        database.string(), holder));
  }
  const std::string note = fmt::format(
      "process {} on host {} since {:%FT%TZ}", ::getpid(), host_name(),
      fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
  // The note only serves messages; the lock itself does not depend on it.
  if (::ftruncate(descriptor_, 0) != 0 ||
      ::pwrite(descriptor_, note.data(), note.size(), 0) != static_cast<ssize_t>(note.size())) {
    const int reason = errno;
    ::close(descriptor_);
    throw Error(fmt::format("cannot write {}: {}", path.string(), std::strerror(reason)));
  }
}

Lock::~Lock() { ::close(descriptor_); }

std::optional<std::string> lock_holder(const fs::path& database) {
  const int descriptor = ::open(lock_path(database).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  std::optional<std::string> holder;
  if (::flock(descriptor, LOCK_SH | LOCK_NB) != 0) holder = content(descriptor);
  ::close(descriptor);
  return holder;
}

}  // namespace eerie::db
