#pragma once

#include <string>
#include <vector>

#include "db/jobs/jobs.hpp"

namespace eerie::test {

/// Jobs at v = 15, 16, ... cm/s; the later ones are longer.
inline std::vector<db::NewJob> sample_jobs(int count) {
  std::vector<db::NewJob> jobs;
  for (int i = 0; i < count; ++i) {
    db::NewJob job;
    job.hash = "hash-" + std::to_string(i);
    job.scene = R"({"impact": {"v_imp_cm_per_s": )" + std::to_string(15 + i) + "}}";
    job.q = 1;
    job.phi_d_deg = 40;
    job.v_imp_cm_per_s = 15 + i;
    job.theta_imp_deg = 15;
    job.v_over_v_esc = (15 + i) / 6.14;
    job.particles_per_target = 1000;
    job.seed = 1;
    job.end_time_s = 3e4;
    job.expected_particle_steps = 1e6 + i;
    jobs.push_back(job);
  }
  return jobs;
}

inline db::Result sample_result(double b_over_a) {
  db::Result r;
  r.outcome_class = "perfect-merging";
  r.m_lr_over_m_total = 0.97;
  r.b_over_a = b_over_a;
  r.c_over_a = 0.2;
  r.period_h = 9.36;
  r.eer = b_over_a < 0.3;
  r.n_eer = r.eer ? 1 : 0;
  r.n_remnants = 1;
  r.settled = true;
  r.steps = 1000;
  r.particle_steps = 2e6;
  r.wall_s = 3;
  r.solver_version = "0.1.0";
  r.host = "here";
  return r;
}

inline db::AttemptEnd ended(db::ExitReason reason) {
  db::AttemptEnd end;
  end.reason = reason;
  end.core_seconds = 3;
  end.particle_steps = 2e6;
  return end;
}

}  // namespace eerie::test
