#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace eerie::test {

/// Something that a program did to the disk, as a file system learns it.
struct DiskEvent {
  enum class Kind {
    make_folder,
    make_file,  ///< or empties one that is there, where `size` is 0
    write,
    resize,
    sync,         ///< of a file, by `inode`
    sync_folder,  ///< of the entries of `path`
    rename,       ///< to `target`, whatever was there
    remove,
    say,  ///< text that the world has seen
  };
  Kind kind = Kind::say;
  std::filesystem::path path = {}, target = {};
  std::uint64_t inode = 0;
  std::int64_t offset = 0;
  std::int64_t size = -1;
  std::string bytes = {};
};

/// This system lets no test trace processes.
struct NoTracing : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs a shell script in a folder and records what it and all its processes do to files below it,
/// in order. What is written to the file `said` there counts as said. Throws NoTracing where
/// processes may not be traced or are no x86-64, and std::runtime_error for a call that is not
/// recorded yet. The calling process must have no other children.
std::vector<DiskEvent> recorded(const std::filesystem::path& folder, const std::string& script);

}  // namespace eerie::test
