#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "db/store/place.hpp"

namespace eerie::db {

/// The lock of the one manager that works on a database. It is a flock on the file itself, under
/// any of its names, and on "<database>.lock", which names the holder. The kernel releases it when
/// the process ends in any way, so nobody ever unlocks by hand.
class Lock {
 public:
  /// The time to wait for the lock. It suffices for a command that carries out its own request.
  static constexpr std::chrono::milliseconds usual_patience{500};

  /// Takes the lock and makes an empty file where there is none. Throws LockedError, which names
  /// process and host of the holder, where that does not release it in time. Throws InputError and
  /// Error as resolved() does.
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

/// The holder, "process 123 on host a since 2024-01-01T00:00:00Z"; nothing where the database is
/// free.
std::optional<std::string> lock_holder(const std::filesystem::path& database);

}  // namespace eerie::db
