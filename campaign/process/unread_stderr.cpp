#include "campaign/process/unread_stderr.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace eerie::process {
namespace {

/// As fopencookie(3) wants it: says that all was written.
ssize_t write_what_can_be(void*, const char* text, size_t size) {
  for (size_t done = 0; done < size;) {
    const ssize_t written = ::write(STDERR_FILENO, text + done, size - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) break;
    done += static_cast<size_t>(written);
  }
  return static_cast<ssize_t>(size);
}

}  // namespace

void let_stderr_go_unread() {
  cookie_io_functions_t functions{};
  functions.write = write_what_can_be;
  std::FILE* stream = ::fopencookie(nullptr, "w", functions);
  if (stream == nullptr) return;
  std::setvbuf(stream, nullptr, _IONBF, 0);
  stderr = stream;  // glibc lets a program do so
}

}  // namespace eerie::process
