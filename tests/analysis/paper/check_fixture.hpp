#pragma once

#include <functional>

#include "analysis/paper/check.hpp"

namespace eerie::test {

inline const paper::Fact& fact_named(const std::string& name) {
  for (const paper::Fact& fact : paper::paper_facts())
    if (fact.name == name) return fact;
  throw std::logic_error("no fact " + name);
}

/// A run whose largest remnant has this b/a; what else it is, is that of a clean merger.
inline paper::ImpactRun run_with(double b_over_a, std::int64_t seed = 1) {
  paper::ImpactRun run;
  run.v_imp_cm_per_s = 20, run.theta_imp_deg = 15;
  run.settings = {1000, "survey", "survey"};
  run.seed = seed;
  run.outcome = "perfect-merging";
  run.m_lr_over_m_total = 0.97;
  run.period_h = 9.36;
  run.ended_at_s = 3e4;
  run.remnants = {{1, 0.95, 300, 300 * b_over_a, b_over_a, b_over_a < 0.3}};
  return run;
}

/// One run at each point of a fact.
inline std::vector<paper::ImpactRun> runs_of(
    const paper::Fact& fact,
    const std::function<paper::ImpactRun(const paper::ImpactPoint&)>& run_at) {
  std::vector<paper::ImpactRun> runs;
  for (const paper::ImpactPoint& point :
       fact.point ? std::vector{*fact.point} : paper::points_of(fact.grids)) {
    runs.push_back(run_at(point));
    runs.back().q = fact.q, runs.back().phi_d_deg = fact.phi_d_deg;
    runs.back().v_imp_cm_per_s = point.v_imp_cm_per_s;
    runs.back().theta_imp_deg = point.theta_imp_deg;
  }
  return runs;
}

/// The reference impact with these b/a, one per seed.
inline std::vector<paper::ImpactRun> seeds_with(const std::vector<double>& b_over_a) {
  std::vector<paper::ImpactRun> runs;
  for (const double value : b_over_a)
    runs.push_back(run_with(value, static_cast<std::int64_t>(runs.size() + 1)));
  return runs;
}

}  // namespace eerie::test
