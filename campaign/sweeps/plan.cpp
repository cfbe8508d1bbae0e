#include "campaign/sweeps/plan.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "campaign/sweeps/beginnings.hpp"
#include "campaign/sweeps/fidelity.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/text/given_file.hpp"
#include "campaign/text/json_file.hpp"

namespace eerie::sweeps {

Plan plan(const nlohmann::json& document, const std::vector<std::string>& overrides,
          const std::string& where) {
  Sweep sweep = parse_sweep(document, overrides, where);
  std::vector<Scene> scenes = expand(sweep);
  require_beginnings(scenes);
  std::vector<db::NewJob> jobs = identify(scenes);
  return {std::move(sweep), std::move(scenes), std::move(jobs)};
}

Plan load_plan(const std::filesystem::path& file, const SceneChanges& changes) {
  const nlohmann::json document = text::load_given_json(file);
  const std::string where = text::given_name(file);
  Plan made = plan(document, changes.all(), where);
  made.replaced = changes.replaced(document.value("scene", nlohmann::json::object()), where);
  return made;
}

std::vector<std::string> departures(const Plan& plan) {
  if (!plan.jobs.front().fidelity.empty() || varies_default_fidelity(plan.sweep)) return {};
  return departures(plan.sweep.scene, plan.sweep.where);
}

db::AddedSweep store(db::Connection& connection, const Plan& plan) {
  return db::add_sweep(connection, plan.sweep.name, document(plan.sweep), plan.jobs);
}

db::AddedSweep store(SQLite::Database& transaction, const Plan& plan) {
  return db::add_sweep(transaction, plan.sweep.name, document(plan.sweep), plan.jobs);
}

}  // namespace eerie::sweeps
