#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/remnants/analysis.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/job_folder/result_file.hpp"
#include "solver/base/file.hpp"

namespace eerie::test {

/// A run of `scene` as the solver would report it: one EER that holds 0.97 of the mass.
inline run::RunSummary sample_summary(const Scene& scene) {
  run::RunSummary s;
  s.progress.time = s.progress.end_time = scene.end.time_s;
  s.progress.step = 1000;
  s.progress.particle_steps = 2e6;
  s.progress.wall_s = 3;
  s.steps_here = 1000;
  s.list_builds = 20;
  s.threads = 2;
  s.first_totals.angular_momentum = {0, 0, 1e10};
  s.last_totals.angular_momentum = {0, 0, 1.0001e10};
  return s;
}

inline remnants::Analysis sample_analysis() {
  remnants::Analysis a;
  a.outcome = remnants::OutcomeClass::perfect_merging;
  a.m_lr_over_m_total = 0.97;
  a.m_slr_over_m_total = 0.01;
  a.settled = false;
  a.unsettled_reason = "remnants 1 and 2 meet again in 2.1 h";
  remnants::Remnant r;
  r.rank = 1;
  r.particles = 1940;
  r.mass = 2.7e9;
  r.mass_over_total = 0.97;
  r.shape.a = 200;
  r.shape.b = 48;
  r.shape.c = 40;
  r.spin_period = 9.36 * 3600;
  r.eer = true;
  r.target_fraction = 0.5;
  r.bound_group = 1;
  r.bound_mass_over_total = 0.98;
  r.x = {1, 2, 3};
  remnants::Remnant second = r;
  second.rank = 2;
  second.eer = false;
  second.spin_period = std::nullopt;
  a.remnants = {r, second};
  return a;
}

/// What a worker leaves behind when all went well.
inline void install_result(const job_folder::JobDirectory& directory, const Scene& scene) {
  std::filesystem::create_directories(directory.path);
  install_text(directory.result(),
               job_folder::result_json(scene, sample_summary(scene), sample_analysis()).dump());
}

}  // namespace eerie::test
