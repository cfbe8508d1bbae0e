#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>

namespace eerie::db {

/// The file of a database under its own name. It follows symbolic links, so that lock, log, inbox
/// and job directories are the same under every name. Throws InputError for names that SQLite does
/// not take as files ("", ":memory:", "file:..."). Throws Error for a folder, a device, or a file
/// with several hard links, for which SQLite would keep separate logs.
std::filesystem::path resolved(const std::filesystem::path& database);

/// The identity of a file, which does not depend on its name.
struct FileIdentity {
  dev_t device = 0;
  ino_t inode = 0;
  bool operator==(const FileIdentity&) const = default;
};
/// The identity of the file at this path; nothing where there is none.
std::optional<FileIdentity> identity(const std::filesystem::path& file);

}  // namespace eerie::db
