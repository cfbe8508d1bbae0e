#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace eerie::db {

/// Holds "<database>.lock" by flock, so that one manager at a time works on a database. The
/// kernel lets go when the process ends, however it ends: nothing is ever unlocked by hand.
class Lock {
 public:
  /// Throws LockedError naming process and host of the holder.
  explicit Lock(const std::filesystem::path& database);
  ~Lock();
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  int descriptor_;
};

/// "process 123 on host a since 2024-01-01T00:00:00Z", or nothing when the database is free.
std::optional<std::string> lock_holder(const std::filesystem::path& database);

}  // namespace eerie::db
