#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "campaign/manager/request.hpp"
#include "db/store/connection.hpp"

namespace eerie::manager {

/// "<database>.inbox": the folder of requests to whoever works on the database, a file each. The
/// database stays in one writer's hands, and a request outlives both sides.
class Inbox {
 public:
  explicit Inbox(const std::filesystem::path& database);

  void put(const Request& request) const;

  /// Carries out what lies there, oldest first; returns how many. A file that is no request is set
  /// aside as ".refused".
  std::size_t take(db::Connection& connection) const;

  bool is_empty() const;

 private:
  std::filesystem::path folder_;
};

/// Has a request carried out: here, where nobody works on the database, else by whoever does.
/// Nothing where the answer takes longer than `patience`; it is carried out all the same.
std::optional<nlohmann::json> send(const std::filesystem::path& database, const Request& request,
                                   std::chrono::milliseconds patience);

}  // namespace eerie::manager
