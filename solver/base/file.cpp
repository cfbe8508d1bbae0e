#include "solver/base/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <tuple>

#include "solver/base/error.hpp"
#include "solver/base/files/destination.hpp"
#include "solver/base/free_space.hpp"
#include "solver/base/kill_point.hpp"

namespace eerie {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(std::string_view doing, const fs::path& path) {
  throw EnvironmentError(
      fmt::format("cannot {} {}: {}", doing, path.string(), std::strerror(errno)));
}

void sync_path(const fs::path& path, int flags) {
  const int fd = ::open(path.c_str(), flags | O_CLOEXEC);
  if (fd < 0) fail("open", path);
  const int status = ::fsync(fd);
  const int saved = errno;
  ::close(fd);
  errno = saved;
  // Some file systems cannot fsync a directory and say EINVAL; the rename is all they offer.
  if (status != 0 && errno != EINVAL) fail("flush", path);
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

void rename_file(const fs::path& from, const fs::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) fail("install", to);
}

/// The pid keeps two writers apart; the name starts with a dot so that globs pass it by.
fs::path temporary_beside(const fs::path& path) {
  return folder_of(path) / fmt::format(".{}.{}.tmp", path.filename().string(), ::getpid());
}

/// `asked` is the file that an error names.
void write_text(const fs::path& path, std::string_view text, const fs::path& asked) {
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  if (!out) fail("create", asked);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) fail("write", asked);
}

/// A folder of our own, for a file on its way into a stream.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (fs::temp_directory_path() / "eerie-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) fail("make", pattern);
    path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// A file that is replaced passes its permissions on.
void keep_permissions(const fs::path& from, const fs::path& to) {
  std::error_code ignored;
  const fs::file_status status = fs::status(from, ignored);
  if (fs::is_regular_file(status)) fs::permissions(to, status.permissions(), ignored);
}

}  // namespace

std::string read_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw EnvironmentError(fmt::format("cannot read {}: it is a folder", path.string()));
  std::ifstream in(path, std::ios::binary);
  if (!in) fail("read", path);
  try {
    std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (!in.bad()) return text;
  } catch (const std::ios_base::failure&) {  // the disk's own trouble
  }
  fail("read", path);
}

void install_file(const fs::path& given, const std::function<void(const fs::path&)>& write,
                  const fs::path& previous) {
  const Destination to = destination_of(given);
  if (to.is_stream) {
    const ScratchFolder scratch;
    write(scratch.path() / given.filename());
    return pour(scratch.path() / given.filename(), to.path);
  }
  const fs::path& path = to.path;
  const fs::path folder = folder_of(path), temporary = temporary_beside(path);
  const std::string name = path.filename().string();
  try {
    kill_point("install.before-write", name);
    write(temporary);
    keep_permissions(path, temporary);
    kill_point("install.before-sync", name);
    sync_path(temporary, O_RDONLY);
    kill_point("install.before-rename", name);
    std::error_code ignored;
    if (!previous.empty() && fs::exists(path, ignored)) {
      rename_file(path, previous);
      kill_point("checkpoint.between", name);
    }
    rename_file(temporary, path);
    kill_point("install.before-folder-sync", name);
    sync_path(folder, O_RDONLY | O_DIRECTORY);
  } catch (const std::exception& error) {
    // Asked while the part that was written still takes its room: libraries below keep no errno.
    const bool full = !has_room(folder, 1 << 16);
    std::error_code ignored;
    fs::remove(temporary, ignored);
    if (full) throw DiskFullError(fmt::format("{}; the disk is full", error.what()));
    throw;
  }
}

void install_text(const fs::path& path, std::string_view text, const fs::path& previous) {
  const auto write = [&](const fs::path& temporary) { write_text(temporary, text, path); };
  install_file(path, write, previous);
}

void show_text(const fs::path& path, std::string_view text) {
  const fs::path temporary = temporary_beside(path);
  try {
    write_text(temporary, text, path);
    rename_file(temporary, path);
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
}

void append_text(const fs::path& path, std::string_view text) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (fd < 0) fail("open", path);
  const off_t end = ::lseek(fd, 0, SEEK_END);
  const bool whole = write_all(fd, text) == text.size();
  const int reason = errno;
  // Where even this fails a part of a line stays, which readers leave out.
  if (!whole && end >= 0) std::ignore = ::ftruncate(fd, end);
  ::close(fd);
  if (whole) return;
  errno = reason;
  if (reason == ENOSPC || reason == EDQUOT)
    throw DiskFullError(fmt::format("cannot write {}: the disk is full", path.string()));
  fail("write", path);
}

void flush_file(const fs::path& path) { sync_path(path, O_RDONLY); }

std::vector<fs::path> half_written_files(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing))
    if (entry.path().filename().string().starts_with('.') && entry.path().extension() == ".tmp")
      found.push_back(entry.path());
  return found;
}

void replace_file(const fs::path& from, const fs::path& to) {
  rename_file(from, to);
  sync_path(folder_of(to), O_RDONLY | O_DIRECTORY);
}

}  // namespace eerie
