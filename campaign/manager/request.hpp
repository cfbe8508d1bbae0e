#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "db/store/connection.hpp"
#include "db/jobs/selection.hpp"

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
/// Throws InputError.
Request parse_request(const nlohmann::json& document, const std::string& where);

/// An id that sorts by the time at which it was made.
std::string new_request_id();

/// Carries a request out and gives the answer, e.g. {"jobs": 3, "added": 1}, or {"error": ...}
/// where its input cannot be used. The caller is the database's only writer.
nlohmann::json apply(db::Connection& connection, const Request& request);

}  // namespace eerie::manager
