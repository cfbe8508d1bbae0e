#pragma once

#include <filesystem>

namespace eerie::db {

/// Name of the network or cluster file system with this statfs() type, or nullptr for a local one.
const char* network_file_system(unsigned long statfs_type);

/// Throws Error where `path` lies on a network file system: SQLite's locks do not hold there,
/// and two hosts would damage the database.
void require_local_disk(const std::filesystem::path& path);

}  // namespace eerie::db
