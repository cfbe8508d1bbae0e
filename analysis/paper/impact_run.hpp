#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/paper/threshold.hpp"

namespace eerie::paper {

/// A remnant of at least 100 particles, with the numbers that facts about impacts need.
struct RunRemnant {
  int rank = 1;  ///< 1: the most massive
  double mass_over_total = 0;
  std::optional<double> a_m = {}, b_m = {}, b_over_a = {};
  bool eer = false;
};

/// The settings of a run. Only runs of equal settings are compared.
struct RunSettings {
  std::int64_t particles_per_target = 0;
  std::string name;      ///< the fidelity, or the scheme where there is none
  std::string fidelity;  ///< empty where there is none
  std::int64_t id = 0;   ///< number of the settings in the database; two settings may share a name
  auto operator<=>(const RunSettings&) const = default;  // NOLINT(modernize-use-nullptr): no 0 here
};

/// One finished impact between the paper's bodies (Sugiura et al. 2019, Tables 1 and 2).
struct ImpactRun {
  double q = 1, phi_d_deg = 40, v_imp_cm_per_s = 0, theta_imp_deg = 0;
  RunSettings settings;
  std::int64_t seed = 1;
  double stiffness = 1;  ///< A and B of the equation of state, in units of the paper's
  std::string outcome;   ///< class name (outcome.hpp)
  double m_lr_over_m_total = 0;
  std::optional<double> period_h = {};  ///< of the largest remnant
  double ended_at_s = 0;
  bool settled = true;                    ///< no remnants will meet again
  std::vector<RunRemnant> remnants = {};  ///< the most massive first

  /// b/a of the largest remnant; 1 where there is none.
  double b_over_a() const { return remnants.empty() ? 1 : remnants.front().b_over_a.value_or(1); }
};

/// An impact of a database matches one of the paper where their values differ by no more than this.
inline constexpr double same_q = 1e-6, same_phi_d_deg = 1e-6, same_v_cm_per_s = 0.01,
                        same_theta_deg = 0.01;

/// Collects the runs into cells of a map, one per (v, theta). It ignores q, phi_d and settings, so
/// the caller must pass runs that belong together.
std::vector<RidgeCell> ridge_cells(const std::vector<ImpactRun>& runs);

}  // namespace eerie::paper
