#include "campaign/merging/job_files.hpp"

#include <fmt/format.h>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::merging {
namespace fs = std::filesystem;

namespace {

/// What belongs to a worker at work, and not to the job.
bool is_passing(const fs::path& file) {
  const job_folder::JobDirectory job{file.parent_path()};
  return file == job.worker_lock() || file == job.heartbeat() || file == job.stop() ||
         file.extension() == ".tmp";
}

/// Whether a copy has been made before, by a merge that did not get to its end.
bool holds_the_same(const fs::path& from, const fs::path& to) {
  if (!fs::is_directory(to)) return false;
  for (const auto& entry : fs::directory_iterator(from)) {
    if (!entry.is_regular_file() || is_passing(entry.path())) continue;
    const fs::path copy = to / entry.path().filename();
    if (!fs::is_regular_file(copy) || fs::file_size(copy) != entry.file_size() ||
        read_file(copy) != read_file(entry.path()))
      return false;
  }
  return true;
}

/// Each file is flushed before it has its name.
void copy_files(const fs::path& from, const fs::path& to) {
  fs::create_directory(to);
  for (const auto& entry : fs::directory_iterator(from)) {
    if (!entry.is_regular_file() || is_passing(entry.path())) continue;
    install_file(to / entry.path().filename(), [&](const fs::path& temporary) {
      fs::copy_file(entry.path(), temporary, fs::copy_options::overwrite_existing);
    });
  }
}

/// A name beside `path` that nothing has.
fs::path free_name(const fs::path& path) {
  fs::path name = path.string() + ".before-merge";
  for (int k = 2; fs::exists(fs::symlink_status(name)); ++k)
    name = fmt::format("{}.before-merge-{}", path.string(), k);
  return name;
}

void put_aside(const fs::path& path) {
  const fs::file_status status = fs::symlink_status(path);
  if (!fs::exists(status)) return;
  if (fs::is_symlink(status) || (fs::is_directory(status) && fs::is_empty(path)))
    fs::remove(path);
  else
    fs::rename(path, free_name(path));
}

}  // namespace

bool transfer(const job_folder::JobDirectory& from, const job_folder::JobDirectory& to,
              Transfer how) {
  try {
    std::error_code ignored;
    if (!fs::is_directory(from.path, ignored)) return false;
    const bool is_link = fs::is_symlink(fs::symlink_status(to.path));
    if (fs::equivalent(from.path, to.path, ignored) && (how == Transfer::link || !is_link))
      return true;
    if (how == Transfer::copy && !is_link && holds_the_same(from.path, to.path)) return true;
    // Links lead to the folder itself, and not to another link.
    const fs::path origin = fs::canonical(from.path);
    // One name, so that what a killed merge has left is removed: the target is locked.
    const fs::path made =
        to.path.parent_path() / fmt::format(".{}.merging.tmp", to.path.filename().string());
    fs::remove_all(made);
    if (how == Transfer::link)
      fs::create_directory_symlink(origin, made);
    else
      copy_files(origin, made);
    put_aside(to.path);
    replace_file(made, to.path);
    return true;
  } catch (const fs::filesystem_error& error) {
    throw EnvironmentError(fmt::format("{}: cannot be brought to {}: {}", from.path.string(),
                                       to.path.string(), error.code().message()));
  }
}

}  // namespace eerie::merging
