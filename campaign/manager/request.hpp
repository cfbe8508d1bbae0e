#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "db/jobs/selection.hpp"
#include "db/store/connection.hpp"

namespace eerie::manager {

/// A request of a user to the process that works on a database.
struct Request {
  std::string id = {};  ///< a request is carried out once, even if it is read again
  /// Submit, pause, resume, cancel, retry, rerun-stale, priority, wall-limit, extend.
  std::string kind = {};
  db::Selection selection = {};
  std::string sweep = {};  ///< for submit: the sweep as JSON
  std::optional<int> priority = {};
  std::optional<double> wall_limit_s = {};  ///< s; empty: no limit
  std::optional<double> until_s = {};       ///< for extend: the later end, simulated time
};

nlohmann::json to_json(const Request& request);
/// Reads a request. Unknown and missing keys are errors, and only {"all": true} selects every job.
/// Throws InputError.
Request parse_request(const nlohmann::json& document, const std::string& where);

/// Throws InputError for a request that no manager can carry out, because its kind is unknown or a
/// number is out of range.
void require_usable(const Request& request);

/// Makes an id that no other request has.
std::string new_request_id();

/// Carries out a request and returns the answer, such as {"jobs": 3, "added": 1}, or {"error": ...}
/// where it cannot. The caller is the only writer of the database. Throws for problems of the
/// database; the request may succeed later.
nlohmann::json apply(db::Connection& connection, const Request& request);

}  // namespace eerie::manager
