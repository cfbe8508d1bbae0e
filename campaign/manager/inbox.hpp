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

/// The folder "<database>.inbox" of requests to the process that works on a database, with one file
/// per request. So the database has one writer, and a request survives the end of either side.
class Inbox {
 public:
  explicit Inbox(const std::filesystem::path& database);

  void put(const Request& request) const;

  /// Carries out the requests in the order in which they arrived, and returns their number. It
  /// renames a file to ".refused", with the reason beside it in ".reason", where the file is no
  /// request, cannot be carried out, or has a foreign owner. Owners that are not foreign are root,
  /// the owner of the database and the user of this process. Throws only for problems of the
  /// database; remaining requests then wait for the next call.
  std::size_t take(db::Connection& connection) const;

  bool is_empty() const;

 private:
  std::string refused(const std::filesystem::path& file, db::Connection& connection) const;
  void remove(const std::filesystem::path& file) const;
  void set_aside(const std::filesystem::path& file, const std::string& why) const;
  std::vector<std::filesystem::path> waiting() const;

  std::filesystem::path database_, folder_;
  /// Files that are done, but can be neither removed nor renamed.
  mutable std::set<std::string> stuck_;
};

/// Has a request carried out, by this process where nobody works on the database, and otherwise by
/// the process that does. Nothing where the answer takes longer than `patience`; the request is
/// still carried out.
std::optional<nlohmann::json> send(const std::filesystem::path& database, const Request& request,
                                   std::chrono::milliseconds patience);

}  // namespace eerie::manager
