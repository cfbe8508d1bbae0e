#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "db/jobs/selection.hpp"
#include "db/store/connection.hpp"

namespace eerie::manager {

/// What a user asks of whoever works on a database.
struct Request {
  std::string id = {};  ///< carried out once, however often it is read
  std::string kind =
      {};  ///< submit, pause, resume, cancel, retry, rerun-stale, priority, wall-limit
  db::Selection selection = {};
  std::string sweep = {};  ///< submit: the sweep as JSON
  std::optional<int> priority = {};
  std::optional<double> wall_limit_s = {};  ///< s; empty: none
};

nlohmann::json to_json(const Request& request);
/// Strict: keys that the kind does not have, or lacks, are errors, and every job is selected by
/// {"all": true} alone. Throws InputError.
Request parse_request(const nlohmann::json& document, const std::string& where);

/// Throws InputError for a request that nobody can carry out as it stands: of no known kind, of
/// numbers out of range.
void require_usable(const Request& request);

/// An id that no other request has.
std::string new_request_id();

/// Carries a request out and gives the answer, e.g. {"jobs": 3, "added": 1}, or {"error": ...}
/// where it cannot be. The caller is the database's only writer. Throws where the database is in
/// trouble: the same may succeed later.
nlohmann::json apply(db::Connection& connection, const Request& request);

}  // namespace eerie::manager
