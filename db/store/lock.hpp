#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "db/store/place.hpp"

namespace eerie::db {

/// Held by the one manager that works on a database: by flock on the file itself, whatever name
/// it is called by, and on "<database>.lock", which says who it is. The kernel lets go when the
/// process ends, however it ends: nothing is ever unlocked by hand.
class Lock {
 public:
  /// Long enough for a command that carries out a request on the spot.
  static constexpr std::chrono::milliseconds usual_patience{500};

  /// Makes an empty file where there is none. Throws LockedError naming process and host of the
  /// holder, where that does not let go in time; InputError and Error as resolved() does.
  explicit Lock(const std::filesystem::path& database,
                std::chrono::milliseconds patience = usual_patience);
  ~Lock();
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  bool take(const std::filesystem::path& database);
  bool take_note(const std::filesystem::path& path);

  std::optional<FileIdentity> held_;
  int note_ = -1;  ///< descriptor of "<database>.lock"
};

/// "process 123 on host a since 2024-01-01T00:00:00Z", or nothing when the database is free.
std::optional<std::string> lock_holder(const std::filesystem::path& database);

}  // namespace eerie::db
