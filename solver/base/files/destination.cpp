#include "solver/base/files/destination.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <optional>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(std::string_view doing, const fs::path& path, int reason) {
  throw EnvironmentError(
      fmt::format("cannot {} {}: {}", doing, path.string(), std::strerror(reason)));
}

/// The descriptor that /dev/fd/3 or /proc/self/fd/3 names. Such a file may have a name of its own,
/// but whoever gave it to us holds the open file, not the name.
std::optional<int> descriptor_named(const fs::path& path) {
  const std::string text = path.string();
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!text.starts_with(folder)) continue;
    int number = -1;
    const char* end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data() + folder.size(), end, number);
    if (problem == std::errc{} && stop == end && number >= 0) return number;
  }
  return std::nullopt;
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

int open_stream(const fs::path& stream) {
  if (const auto named = descriptor_named(stream)) return ::fcntl(*named, F_DUPFD_CLOEXEC, 0);
  return ::open(stream.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
}

}  // namespace

std::size_t write_all(int descriptor, std::string_view bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t written = ::write(descriptor, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) break;
    done += static_cast<std::size_t>(written);
  }
  return done;
}

Destination destination_of(const fs::path& path) {
  constexpr int most_links = 40;  // as the kernel
  fs::path here = path;
  for (int links = 0; links <= most_links; ++links) {
    if (descriptor_named(here)) return {here, true};
    struct stat info {};
    if (::lstat(here.c_str(), &info) != 0) return {here, false};
    if (S_ISDIR(info.st_mode)) fail("write", path, EISDIR);
    if (!S_ISLNK(info.st_mode)) return {here, !S_ISREG(info.st_mode)};
    here = here.parent_path() / fs::read_symlink(here);
  }
  fail("write", path, ELOOP);
}

void pour(const fs::path& from, const fs::path& stream) {
  const std::string bytes = read_file(from);
  std::fflush(stdout);  // it may be the same stream, and came first
  const Descriptor to(open_stream(stream));
  if (to.number() < 0) fail("open", stream, errno);
  if (write_all(to.number(), bytes) < bytes.size()) fail("write", stream, errno);
}

}  // namespace eerie
