#pragma once

#include <filesystem>

namespace eerie::db {

/// The name of the network or cluster file system with this statfs() type; nullptr for a local one.
const char* network_file_system(unsigned long statfs_type);

/// Throws Error where `path` lies on a network file system. SQLite's locks do not work there, so
/// two hosts would damage the database.
void require_local_disk(const std::filesystem::path& path);

}  // namespace eerie::db
