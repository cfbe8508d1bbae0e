#include "campaign/job_folder/result_file.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/job_folder/provenance.hpp"
#include "solver/base/sha256.hpp"
#include "solver/scene/tide.hpp"

namespace eerie::job_folder {
using nlohmann::json;

namespace {

json totals_json(const step::Totals& t) {
  return {{"kinetic_energy_J", t.kinetic_energy},
          {"potential_energy_J", t.potential_energy},
          {"internal_energy_J", t.internal_energy},
          {"viscous_heat_J", t.viscous_heat},
          {"friction_heat_J", t.friction_heat},
          {"momentum_kg_m_per_s", {t.momentum.x, t.momentum.y, t.momentum.z}},
          {"angular_momentum_kg_m2_per_s",
           {t.angular_momentum.x, t.angular_momentum.y, t.angular_momentum.z}}};
}

}  // namespace

std::optional<double> angular_momentum_drift(const Scene& scene, const step::Totals& start,
                                             const step::Totals& end) {
  if (has_primary(scene)) return std::nullopt;  // which turns them
  const Vec3 before = start.angular_momentum, after = end.angular_momentum;
  const double reduced_mass = target_mass(scene) * scene.impact.q / (1 + scene.impact.q);
  const double grazing = reduced_mass * scene.impact.v_imp_cm_per_s / 100 * contact_distance(scene);
  if (norm(before) < 1e-6 * grazing) return std::nullopt;
  return norm(after - before) / norm(before);
}

std::vector<std::string> run_warnings(const Scene& scene, const run::RunSummary& summary) {
  const auto drift = angular_momentum_drift(scene, summary.first_totals, summary.last_totals);
  if (!drift || *drift <= most_angular_momentum_drift) return {};
  return {
      fmt::format("the angular momentum changed by {:.2g} %, more than the {:g} % up to which a "
                  "result is trusted; use more particles, a smaller cfl, or material that is "
                  "less stiff or cohesive",
                  100 * *drift, 100 * most_angular_momentum_drift)};
}

json run_json(const Scene& scene, const run::RunSummary& summary) {
  json stages;
  for (std::size_t i = 0; i < stage_count; ++i)
    stages[std::string(stage_names[i])] = summary.stages.seconds[i];
  const auto drift = angular_momentum_drift(scene, summary.first_totals, summary.last_totals);
  json document = {{"end_time_s", summary.progress.time},
                   {"end_reason", run::end_reason_names[static_cast<std::size_t>(summary.reason)]},
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
  const std::vector<std::string> warnings = run_warnings(scene, summary);
  if (!warnings.empty()) document["warnings"] = warnings;
  return document;
}

json result_json(const Scene& scene, const run::RunSummary& summary,
                 const remnants::Analysis& analysis) {
  json source = to_json(provenance());
  source["seed"] = scene.numerics.seed;
  json document = {{"scene_hash", scene_hash(scene)},
                   {"version", result_version},
                   {"analysis", remnants::to_json(analysis)},
                   {"run", run_json(scene, summary)},
                   {"provenance", std::move(source)}};
  document["sha256"] = sha256_hex(document.dump());
  return document;
}

}  // namespace eerie::job_folder
