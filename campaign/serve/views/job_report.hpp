#pragma once

#include <nlohmann/json_fwd.hpp>

#include "db/jobs/rows.hpp"
#include "db/store/connection.hpp"

namespace eerie::serve {

/// Everything about a job, as `eerie show --json`.
nlohmann::json job_report(const db::Connection& connection, const db::Job& job);

/// The fields of a scene with their defaults: [{"path", "value", "default", "differs", "meaning"}].
/// Fields that differ come first. The defaults are those of the scene's own scheme.
nlohmann::json scene_leaves(const nlohmann::json& scene);

/// history.csv as {"columns": {name: [numbers]}}, without columns where the file does not exist
/// yet.
nlohmann::json history_json(const db::Connection& connection, const db::Job& job);

}  // namespace eerie::serve
