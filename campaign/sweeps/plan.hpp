#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "campaign/sweeps/scene_changes.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "db/jobs/jobs.hpp"

namespace eerie::sweeps {

/// A sweep that is ready to be stored.
struct Plan {
  Sweep sweep;
  std::vector<Scene> scenes;               ///< one per point, in the order of expand(); valid
  std::vector<db::NewJob> jobs;            ///< the distinct jobs of these scenes
  std::vector<std::string> replaced = {};  ///< SceneChanges::replaced() of the file
};

/// Takes a sweep from its file towards the database: parse and check, expand, see whether
/// each can begin, identify. store() is the last step. Throws InputError, which names file,
/// field, value, range and mend.
Plan plan(const nlohmann::json& document, const std::vector<std::string>& overrides,
          const std::string& where);
Plan load_plan(const std::filesystem::path& file, const SceneChanges& changes);

/// departures() of the scene that all points share; nothing where the settings have a name, or
/// where points differ in whether the default fidelity is meant for them.
std::vector<std::string> departures(const Plan& plan);

/// Adds the jobs that the database does not have yet. Adding a sweep twice adds nothing.
db::AddedSweep store(db::Connection& connection, const Plan& plan);
db::AddedSweep store(SQLite::Database& transaction, const Plan& plan);

}  // namespace eerie::sweeps
