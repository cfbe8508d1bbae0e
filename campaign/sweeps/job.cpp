#include "campaign/sweeps/job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "campaign/sweeps/fidelity.hpp"
#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"
#include "solver/scene/guards.hpp"
#include "solver/scene/two_materials.hpp"

namespace eerie::sweeps {

double mutual_escape_speed(const Scene& scene) {
  return eerie::mutual_escape_speed({scene.target.radius_m, scene.material.rho0_kg_per_m3},
                                    impactor_radius(scene), scene.impact.q);
}

/// Medians over some 400 runs of the study of convergence, s: until remnants that do not wait for
/// one another have settled, and as what impacts that fly while they wait are computed as matter.
constexpr double typical_time_to_settle = 3e4;
constexpr double typical_time_without_flight = 5e4;

double expected_end_s(const Scene& scene) {
  if (scene.numerics.rigid_flight) return std::min(scene.end.time_s, typical_time_without_flight);
  if (scene.end.settled.window_s > 0) return std::min(scene.end.time_s, typical_time_to_settle);
  return scene.end.time_s;
}

/// Of the steps at the scene's own sound speed, what remains where matter softens while it moves
/// slowly: 0.18 and 0.17 for the reference impact at 1,000 and 5,000 particles per target.
constexpr double typical_part_with_softening = 0.18;

double expected_particle_steps(const Scene& scene) {
  // Waves are fastest in the less dense body, whose particles are the larger ones.
  const double c = bulk_sound_speed(scene), rho = lowest_density(scene);
  const double c_l = std::sqrt(highest_density(scene) / rho * c * c +
                               4.0 / 3 * scene.material.shear_modulus_Pa / rho);
  const double dt = scene.numerics.cfl * smoothing_length(scene) / c_l;
  const auto particles =
      static_cast<double>(scene.numerics.particles_per_target + impactor_particles(scene));
  const bool softens = softest_sound_speed(scene) < 1 && scene.numerics.flow_mach > 0;
  return particles *
         std::ceil(expected_end_s(scene) / dt * (softens ? typical_part_with_softening : 1));
}

db::NewJob new_job(const Scene& scene) {
  db::NewJob job;
  nlohmann::json canonical = to_json(scene);
  job.scene = canonical.dump();
  job.fidelity = fidelity_of(canonical);
  job.hash = canonical_hash(std::move(canonical));
  job.q = scene.impact.q;
  job.phi_d_deg = scene.material.drucker_prager.phi_d_deg;
  job.v_imp_cm_per_s = scene.impact.v_imp_cm_per_s;
  job.theta_imp_deg = scene.impact.theta_imp_deg;
  job.v_over_v_esc = scene.impact.v_imp_cm_per_s / 100 / mutual_escape_speed(scene);
  job.particles_per_target = scene.numerics.particles_per_target;
  job.seed = scene.numerics.seed;
  job.end_time_s = scene.end.time_s;
  job.expected_particle_steps = expected_particle_steps(scene);
  return job;
}

std::vector<db::NewJob> identify(const std::vector<Scene>& scenes) {
  std::vector<db::NewJob> jobs;
  std::unordered_set<std::string> seen;
  for (const Scene& scene : scenes) {
    db::NewJob job = new_job(scene);
    if (seen.insert(job.hash).second) jobs.push_back(std::move(job));
  }
  return jobs;
}

std::vector<db::NewJob> jobs_in_order(const std::vector<Scene>& scenes) {
  std::vector<db::NewJob> jobs = identify(scenes);
  int priority = 0;
  for (db::NewJob& job : jobs) job.priority = priority--;
  return jobs;
}

std::vector<std::string> cautions(const std::vector<Scene>& scenes) {
  std::vector<std::pair<std::string, std::size_t>> counted;  // in the order of their first scene
  for (const Scene& scene : scenes)
    for (std::string& text : warnings(scene)) {
      const auto known =
          std::ranges::find(counted, text, &std::pair<std::string, std::size_t>::first);
      if (known == counted.end())
        counted.emplace_back(std::move(text), 1);
      else
        ++known->second;
    }
  std::vector<std::string> sentences;
  sentences.reserve(counted.size());
  for (const auto& [text, count] : counted)
    sentences.push_back(count == scenes.size()
                            ? text
                            : fmt::format("{} of {} points: {}", count, scenes.size(), text));
  return sentences;
}

}  // namespace eerie::sweeps
