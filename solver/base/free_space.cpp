#include "solver/base/free_space.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>

namespace eerie {
namespace fs = std::filesystem;

std::optional<std::uintmax_t> free_bytes(const fs::path& folder) {
  struct statvfs info {};
  if (::statvfs(folder.c_str(), &info) != 0) return std::nullopt;
  return static_cast<std::uintmax_t>(info.f_bavail) * info.f_frsize;
}

bool has_room(const fs::path& folder, std::uintmax_t bytes) {
  const fs::path probe = folder / fmt::format(".room.{}.tmp", ::getpid());
  const int descriptor = ::open(probe.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (descriptor < 0) return errno != ENOSPC && errno != EDQUOT;
  const int status = ::posix_fallocate(descriptor, 0, static_cast<off_t>(bytes));
  ::close(descriptor);
  ::unlink(probe.c_str());
  return status != ENOSPC && status != EDQUOT;
}

}  // namespace eerie
