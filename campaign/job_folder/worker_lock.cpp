#include "campaign/job_folder/worker_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "solver/base/error.hpp"

namespace eerie::job_folder {

WorkerLock::WorkerLock(const JobDirectory& directory) {
  const std::string path = directory.worker_lock().string();
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0644);
  if (descriptor_ < 0)
    throw EnvironmentError(fmt::format("cannot open {}: {}", path, std::strerror(errno)));
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const int reason = errno;
  ::close(descriptor_);
  if (reason == EWOULDBLOCK)
    throw DirectoryBusy(
        fmt::format("another process works in {} already", directory.path.string()));
  throw EnvironmentError(fmt::format("cannot lock {}: {}", path, std::strerror(reason)));
}

WorkerLock::~WorkerLock() { ::close(descriptor_); }

bool WorkerLock::held(const JobDirectory& directory) {
  const int descriptor = ::open(directory.worker_lock().c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return false;
  const bool taken = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0;
  ::close(descriptor);
  return taken;
}

}  // namespace eerie::job_folder
