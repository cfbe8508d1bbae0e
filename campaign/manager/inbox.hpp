#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "campaign/manager/request.hpp"
#include "db/store/connection.hpp"

namespace eerie::manager {

/// "<database>.inbox": the folder of requests to whoever works on the database, a file each. The
/// database stays in one writer's hands, and a request outlives both sides.
class Inbox {
 public:
  explicit Inbox(const std::filesystem::path& database);

  void put(const Request& request) const;

  /// Carries out what lies there in the order in which it was put there; returns how many. A file
  /// that is no request, that cannot be carried out, or that belongs to somebody else than root,
  /// the owner of the database and who runs this process, is set aside as ".refused", with the
  /// reason beside it in ".reason". Throws only where the database is in trouble; what is left then
  /// is taken the next time.
  std::size_t take(db::Connection& connection) const;

  bool is_empty() const;

 private:
  std::string refused(const std::filesystem::path& file, db::Connection& connection) const;
  void remove(const std::filesystem::path& file) const;
  void set_aside(const std::filesystem::path& file, const std::string& why) const;
  std::vector<std::filesystem::path> waiting() const;

  std::filesystem::path database_, folder_;
  mutable std::set<std::string> stuck_;  ///< dealt with, and could be neither removed nor renamed
};

/// Has a request carried out: here, where nobody works on the database, else by whoever does.
/// Nothing where the answer takes longer than `patience`; it is carried out all the same.
std::optional<nlohmann::json> send(const std::filesystem::path& database, const Request& request,
                                   std::chrono::milliseconds patience);

}  // namespace eerie::manager
