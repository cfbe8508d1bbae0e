#include "db/store/place.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include "db/store/error.hpp"
#include "solver/base/error.hpp"

namespace eerie::db {
namespace fs = std::filesystem;

namespace {

/// SQLite takes these for a database without a file, or for a URI.
void require_file_name(const std::string& name) {
  const bool is_uri = name.starts_with("file:");
  if (!name.empty() && name != ":memory:" && !is_uri) return;
  throw InputError(fmt::format(
      "--db '{}': is not the name of a file, so nothing would be kept; give a file such as "
      "campaign.sqlite{}",
      name, is_uri ? fmt::format(", or ./{} where it is called so", name) : ""));
}

fs::path behind_links(fs::path path) {
  constexpr int most_links = 40;  // as the kernel follows
  std::error_code ignored;
  for (int k = 0; fs::is_symlink(fs::symlink_status(path, ignored)); ++k) {
    const fs::path target = fs::read_symlink(path, ignored);
    if (ignored || k == most_links)
      throw Error(
          fmt::format("database {}: its symbolic links lead nowhere; mend them, or give "
                      "another file to --db",
                      path.string()));
    path = target.is_absolute() ? target : path.parent_path() / target;
  }
  return path;
}

}  // namespace

fs::path resolved(const fs::path& database) {
  require_file_name(database.string());
  const fs::path path = behind_links(database);
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return path;
  if (S_ISDIR(info.st_mode))
    throw Error(fmt::format("database {}: it is a folder; give a file to --db", path.string()));
  if (!S_ISREG(info.st_mode))
    throw Error(fmt::format("database {}: it is a device, pipe or socket; give a file to --db",
                            path.string()));
  if (info.st_nlink > 1)
    throw Error(fmt::format(
        "database {}: the file has {} names (hard links), and under each of them SQLite would keep "
        "another log and damage it; find them (find DIR -samefile {}) and remove all but one",
        path.string(), info.st_nlink, path.string()));
  return path;
}

std::optional<FileIdentity> identity(const fs::path& file) {
  struct stat info {};
  if (::stat(file.c_str(), &info) != 0) return std::nullopt;
  return FileIdentity{info.st_dev, info.st_ino};
}

}  // namespace eerie::db
