#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "campaign/sweeps/fidelity.hpp"
#include "campaign/sweeps/job.hpp"
#include "db/jobs/jobs.hpp"
#include "tests/db/jobs/sample_jobs.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::test {

/// A scene file of the fidelity "survey".
inline nlohmann::json survey_scene(double q, double phi_d_deg, double v_imp_cm_per_s,
                                   double theta_imp_deg, int seed) {
  nlohmann::json scene = sweeps::settings_of("survey");
  scene["impact"] = {
      {"q", q}, {"v_imp_cm_per_s", v_imp_cm_per_s}, {"theta_imp_deg", theta_imp_deg}};
  scene["material"]["drucker_prager"]["phi_d_deg"] = phi_d_deg;
  scene["numerics"]["seed"] = seed;
  return scene;
}

/// Impacts in a database as if they had been run: a merger with one remnant of this b/a each.
inline void add_impacts(db::Connection& connection,
                        const std::vector<std::pair<nlohmann::json, double>>& impacts,
                        bool settled = true) {
  std::vector<db::NewJob> jobs;
  std::map<std::string, double> b_over_a;
  for (const auto& [scene, shape] : impacts) {
    jobs.push_back(sweeps::new_job(parse_scene(scene)));
    b_over_a[jobs.back().hash] = shape;
  }
  add_sweep(connection, jobs.front().hash.substr(0, 16), "{}", jobs);
  for (const db::Job& job : db::jobs(connection, {std::nullopt, db::JobState::pending})) {
    const double shape = b_over_a.at(job.hash);
    db::begin_attempts(connection, std::vector{db::Start{job.id, "here", "1", "0.1.0"}});
    db::Result result = sample_result(shape);
    result.settled = settled;
    result.ended_at_s = 3e4;
    db::Remnant remnant{.rank = 1, .particles = 1900, .mass_over_total = 0.95};
    remnant.a_m = 300, remnant.b_m = 300 * shape, remnant.b_over_a = shape;
    remnant.eer = result.eer;
    db::finish(connection, job.id, ended(db::ExitReason::finished), result, std::vector{remnant});
  }
}

inline void add_impact(db::Connection& connection, const nlohmann::json& scene, double b_over_a,
                       bool settled = true) {
  add_impacts(connection, {{scene, b_over_a}}, settled);
}

}  // namespace eerie::test
