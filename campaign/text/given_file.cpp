#include "campaign/text/given_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <span>

#include "solver/base/error.hpp"

namespace eerie::text {
namespace fs = std::filesystem;

namespace {

class Source {
 public:
  explicit Source(const fs::path& path)
      : is_standard_input_(path == "-"),
        descriptor_(is_standard_input_ ? STDIN_FILENO
                                       : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~Source() {
    if (!is_standard_input_ && descriptor_ >= 0) ::close(descriptor_);
  }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  /// Bytes read; 0 at the end, negative with errno set where it cannot be read.
  ssize_t read(std::span<char> room) const {
    if (descriptor_ < 0) return -1;
    ssize_t bytes = 0;
    do bytes = ::read(descriptor_, room.data(), room.size());
    while (bytes < 0 && errno == EINTR);
    return bytes;
  }

 private:
  bool is_standard_input_;
  int descriptor_;
};

}  // namespace

std::string read_given(const fs::path& path, std::size_t most_bytes) {
  const Source source(path);
  std::string text;
  std::array<char, 1 << 16> room;
  while (true) {
    const ssize_t bytes = source.read(room);
    if (bytes < 0)
      throw InputError(
          fmt::format("{}: cannot be read: {}; give a file, a pipe, or - for standard "
                      "input",
                      given_name(path), std::strerror(errno)));
    if (bytes == 0) return text;
    text.append(room.data(), static_cast<std::size_t>(bytes));
    if (text.size() > most_bytes)
      throw InputError(fmt::format("{}: more than the {} bytes that any file of its kind has",
                                   given_name(path), most_bytes));
  }
}

std::string given_name(const fs::path& path) {
  return path == "-" ? "standard input" : path.string();
}

bool is_named_file(const fs::path& path) {
  std::error_code ignored;
  return path != "-" && !path.string().starts_with("/dev/") &&
         !path.string().starts_with("/proc/") && fs::is_regular_file(path, ignored);
}

}  // namespace eerie::text
