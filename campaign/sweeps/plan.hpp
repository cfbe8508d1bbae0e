#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "campaign/sweeps/sweep.hpp"
#include "db/jobs/jobs.hpp"

namespace eerie::sweeps {

/// A sweep that is ready to be stored.
struct Plan {
  Sweep sweep;
  std::vector<Scene> scenes;     ///< one per point, in the order of expand(); valid
  std::vector<db::NewJob> jobs;  ///< the distinct jobs of these scenes
};

/// Takes a sweep from its file towards the database: parse and check, expand, identify. store() is
/// the last step. Throws InputError, which names file, field, value, range and mend.
Plan plan(const nlohmann::json& document, const std::vector<std::string>& overrides,
          const std::string& where);
Plan load_plan(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// Adds the jobs that the database does not have yet. Adding a sweep twice adds nothing.
db::AddedSweep store(db::Connection& connection, const Plan& plan);
db::AddedSweep store(SQLite::Database& transaction, const Plan& plan);

}  // namespace eerie::sweeps
