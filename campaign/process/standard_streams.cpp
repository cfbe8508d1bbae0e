#include "campaign/process/standard_streams.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>

namespace eerie::process {
namespace {

/// Of the environment; 0 where it says none.
std::size_t columns_wanted() {
  const char* text = std::getenv("COLUMNS");
  const long columns = text == nullptr ? 0 : std::strtol(text, nullptr, 10);
  return columns > 0 && columns < 100'000 ? static_cast<std::size_t>(columns) : 0;
}

std::size_t columns_of_terminal(int descriptor) {
  constexpr std::size_t usual = 80;
  winsize size{};
  return ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

}  // namespace

Terminal terminal_at(int descriptor) {
  Terminal t;
  t.is_one = ::isatty(descriptor) != 0;
  const char* kind = std::getenv("TERM");
  t.is_dumb = !t.is_one || kind == nullptr || std::string_view(kind) == "dumb";
  t.width = columns_wanted();
  if (t.width == 0 && t.is_one) t.width = columns_of_terminal(descriptor);
  return t;
}

int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN) {
      pollfd ready{descriptor, POLLOUT, 0};
      ::poll(&ready, 1, -1);
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

void guard_standard_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // beyond ulimit -f a write fails with EFBIG, which is told
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) {
      // Opened to read, so that what is printed fails. The lowest free number is this one.
      const int way = descriptor == STDERR_FILENO ? O_WRONLY : O_RDONLY;
      if (::open("/dev/null", way) != descriptor) return;
    }
}

}  // namespace eerie::process
