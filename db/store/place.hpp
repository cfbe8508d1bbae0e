#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>

namespace eerie::db {

/// The file of a database under its own name: a symbolic link is followed, so that lock, log,
/// inbox and job directories are the same whatever it is called. Throws InputError for names that
/// SQLite does not take for a file ("", ":memory:", "file:...") and Error for what is no file of
/// its own: a folder, a device, or one of several hard links, whose logs SQLite would keep apart.
std::filesystem::path resolved(const std::filesystem::path& database);

/// Which file it is, however it is called.
struct FileIdentity {
  dev_t device = 0;
  ino_t inode = 0;
  bool operator==(const FileIdentity&) const = default;
};
/// Nothing where there is no such file.
std::optional<FileIdentity> identity(const std::filesystem::path& file);

}  // namespace eerie::db
