#pragma once

#include <nlohmann/json_fwd.hpp>

#include "db/jobs/rows.hpp"
#include "db/store/connection.hpp"

namespace eerie::serve {

/// All that is known of a job: `eerie show --json`.
nlohmann::json job_report(const db::Connection& connection, const db::Job& job);

/// Leaves of a scene with what they would be by default, those that differ first: [{"path",
/// "value", "default", "differs", "meaning"}]. The defaults are those of the scene's own scheme.
nlohmann::json scene_leaves(const nlohmann::json& scene);

/// history.csv as {"columns": {name: [numbers]}}; no columns where there is none yet.
nlohmann::json history_json(const db::Connection& connection, const db::Job& job);

}  // namespace eerie::serve
