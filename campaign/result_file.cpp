#include "campaign/result_file.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "campaign/provenance.hpp"
#include "solver/base/constants.hpp"

namespace eerie {
using nlohmann::json;

namespace {

json totals_json(const Totals& t) {
  return {{"kinetic_energy_J", t.kinetic_energy},
          {"potential_energy_J", t.potential_energy},
          {"internal_energy_J", t.internal_energy},
          {"viscous_heat_J", t.viscous_heat},
          {"friction_heat_J", t.friction_heat},
          {"momentum_kg_m_per_s", {t.momentum.x, t.momentum.y, t.momentum.z}},
          {"angular_momentum_kg_m2_per_s",
           {t.angular_momentum.x, t.angular_momentum.y, t.angular_momentum.z}}};
}

template <class T>
std::optional<T> optional_value(const json& object, const char* key) {
  const json& value = object.at(key);
  return value.is_null() ? std::nullopt : std::optional<T>(value.get<T>());
}

db::Remnant remnant_row(const json& m) {
  db::Remnant row;
  m.at("rank").get_to(row.rank);
  m.at("particles").get_to(row.particles);
  m.at("mass_kg").get_to(row.mass_kg);
  m.at("mass_over_total").get_to(row.mass_over_total);
  row.a_m = optional_value<double>(m, "a_m");
  row.b_m = optional_value<double>(m, "b_m");
  row.c_m = optional_value<double>(m, "c_m");
  row.b_over_a = optional_value<double>(m, "b_over_a");
  row.c_over_a = optional_value<double>(m, "c_over_a");
  row.spin_period_h = optional_value<double>(m, "spin_period_h");
  m.at("eer").get_to(row.eer);
  row.target_fraction = optional_value<double>(m, "target_fraction");
  row.bound_group = optional_value<std::int64_t>(m, "bound_group");
  row.bound_mass_over_total = optional_value<double>(m, "bound_mass_over_total");
  row.x_m = optional_value<double>(m, "x_m");
  row.y_m = optional_value<double>(m, "y_m");
  row.z_m = optional_value<double>(m, "z_m");
  row.vx_m_per_s = optional_value<double>(m, "vx_m_per_s");
  row.vy_m_per_s = optional_value<double>(m, "vy_m_per_s");
  row.vz_m_per_s = optional_value<double>(m, "vz_m_per_s");
  return row;
}

StoredResult stored_result(const json& document) {
  StoredResult stored;
  for (const json& m : document.at("analysis").at("remnants"))
    stored.remnants.push_back(remnant_row(m));
  db::Result& r = stored.result;
  const json& outcome = document.at("analysis").at("outcome");
  outcome.at("class").get_to(r.outcome_class);
  outcome.at("m_lr_over_m_total").get_to(r.m_lr_over_m_total);
  outcome.at("m_slr_over_m_total").get_to(r.m_slr_over_m_total);
  outcome.at("settled").get_to(r.settled);
  outcome.at("unsettled_reason").get_to(r.unsettled_reason);
  r.n_remnants = static_cast<int>(stored.remnants.size());
  r.n_eer = static_cast<int>(std::count_if(stored.remnants.begin(), stored.remnants.end(),
                                           [](const auto& m) { return m.eer; }));
  if (!stored.remnants.empty()) {
    const db::Remnant& largest = stored.remnants.front();
    r.b_over_a = largest.b_over_a;
    r.c_over_a = largest.c_over_a;
    r.period_h = largest.spin_period_h;
    r.eer = largest.eer;
  }
  const json& run = document.at("run");
  r.dL_over_L = optional_value<double>(run, "dL_over_L");
  run.at("steps").get_to(r.steps);
  run.at("particle_steps").get_to(r.particle_steps);
  run.at("wall_s").get_to(r.wall_s);
  run.at("threads").get_to(r.threads);
  document.at("provenance").at("version").get_to(r.solver_version);
  document.at("provenance").at("host").get_to(r.host);
  return stored;
}

}  // namespace

std::optional<double> angular_momentum_drift(const Scene& scene, const Totals& start,
                                             const Totals& end) {
  const Vec3 before = start.angular_momentum, after = end.angular_momentum;
  const double reduced_mass = target_mass(scene) * scene.impact.q / (1 + scene.impact.q);
  const double grazing = reduced_mass * scene.impact.v_imp_cm_per_s / 100 * contact_distance(scene);
  if (norm(before) < 1e-6 * grazing) return std::nullopt;
  return norm(after - before) / norm(before);
}

json run_json(const Scene& scene, const RunSummary& summary) {
  json stages;
  for (std::size_t i = 0; i < stage_count; ++i)
    stages[std::string(stage_names[i])] = summary.stages.seconds[i];
  const auto drift = angular_momentum_drift(scene, summary.first_totals, summary.last_totals);
  return {{"end_time_s", summary.progress.time},
          {"steps", summary.progress.step},
          {"particle_steps", summary.progress.particle_steps},
          {"wall_s", summary.progress.wall_s},
          {"steps_last_attempt", summary.steps_here},
          {"list_builds_last_attempt", summary.list_builds},
          {"threads", summary.threads},
          {"stages_s", std::move(stages)},
          {"dL_over_L", drift ? json(*drift) : json()},
          {"totals_start", totals_json(summary.first_totals)},
          {"totals_end", totals_json(summary.last_totals)}};
}

json result_json(const Scene& scene, const RunSummary& summary, const Analysis& analysis) {
  json source = to_json(provenance());
  source["seed"] = scene.numerics.seed;
  return {{"scene_hash", scene_hash(scene)},
          {"version", 1},
          {"analysis", to_json(analysis)},
          {"run", run_json(scene, summary)},
          {"provenance", std::move(source)}};
}

std::optional<StoredResult> read_result(const JobDirectory& directory, const std::string& hash) {
  const auto document = read_json(directory.result());
  if (!document || !document->is_object()) return std::nullopt;
  try {
    if (document->at("version") != 1 || document->at("scene_hash") != hash) return std::nullopt;
    return stored_result(*document);
  } catch (const json::exception&) {
    return std::nullopt;  // a file that lacks what a result has is no result
  }
}

}  // namespace eerie
