#pragma once

#include <nlohmann/json.hpp>

#include "campaign/text/table.hpp"
#include "db/store/connection.hpp"
#include "db/views/query.hpp"

namespace eerie::results {

/// A table of the attempts at a job, for programs and for people.
text::Table table_of_attempts(const std::vector<db::AttemptRow>& attempts);

/// Everything about a job: {"hash", "state", "wanted", "priority", "crashes", "wall_limit_s",
/// "sweeps", "scene", "progress", "result", "failure", "attempts", "directory", "files": [{"path",
/// "bytes"}]}. Missing parts are null.
nlohmann::json job_report(const db::Connection& connection, const db::Job& job);

}  // namespace eerie::results
