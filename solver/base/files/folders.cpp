#include "solver/base/files/folders.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

#include "solver/base/error.hpp"

namespace eerie {
namespace fs = std::filesystem;

namespace {

/// A folder that we may not read is flushed by nobody, and one that does not flush says EINVAL.
void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  const int problem = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (problem != 0 && problem != EINVAL)
    throw EnvironmentError(
        fmt::format("cannot flush {}: {}", folder.string(), std::strerror(problem)));
}

}  // namespace

void make_folders(const fs::path& folder) {
  fs::path whole = fs::absolute(folder);
  if (!whole.has_filename()) whole = whole.parent_path();  // "here/"
  std::error_code problem;
  // Deepest first. One that is there is flushed too: whoever made it may have been killed.
  std::vector<fs::path> entries = {whole};
  for (fs::path up = whole.parent_path(); !fs::exists(up, problem); up = up.parent_path())
    entries.push_back(up);
  fs::create_directories(whole, problem);
  if (problem)
    throw EnvironmentError(
        fmt::format("cannot make the folder {}: {}", folder.string(), problem.message()));
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry)
    sync_folder(entry->parent_path());
}

}  // namespace eerie
