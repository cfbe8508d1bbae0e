#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/ensemble.hpp"
#include "db/store/connection.hpp"

namespace eerie::comparison {

/// One of the two sets of results that are compared.
struct ComparedSide {
  const db::Connection* database = nullptr;
  /// The fidelity, or the database's number for the settings; empty: every settings.
  std::string settings = {};
};

/// A quantity of one impact over the seeds of either side.
struct SeedsCompared {
  statistics::Ensemble a, b;

  /// The mean of b minus that of a; nothing where a side has no value.
  std::optional<double> difference() const;
  /// The probability that seeds alone make so large a difference (Welch's t-test, two-sided).
  /// Where one side has a single run, it is held against the scatter of the other. Nothing where
  /// neither side has two runs.
  std::optional<double> chance() const;
  /// Whether seeds alone make such a difference in less than `significant` of all cases.
  bool is_beyond_scatter() const;
};
inline constexpr double significant = 0.05;

/// One impact on both sides.
struct ImpactCompared {
  double q = 0, phi_d_deg = 0, v_imp_cm_per_s = 0, theta_imp_deg = 0;
  std::string settings_a, settings_b;  ///< the fidelity, or "settings N"
  std::string class_a, class_b;        ///< that of most runs
  std::size_t runs_a = 0, runs_b = 0;
  std::size_t of_class_a = 0, of_class_b = 0;  ///< runs of these classes
  SeedsCompared b_over_a, m_lr, period_h;
  std::size_t same_jobs = 0;     ///< jobs (hashes) that both sides have
  std::size_t same_results = 0;  ///< of these, those with the same numbers

  bool has_same_class() const { return class_a == class_b; }
  bool is_beyond_scatter() const;
};

struct Compared {
  std::vector<ImpactCompared> impacts;  ///< by q, friction angle, speed, angle
  std::size_t only_a = 0, only_b = 0;   ///< impacts that one side alone has
};

/// Compares the results of two sides, impact by impact. Stale results are left out. Without chosen
/// settings, results of the same settings are compared. Throws InputError where a side's settings
/// are unknown or have no results, and where no settings are on both sides.
Compared compare(const ComparedSide& a, const ComparedSide& b);

}  // namespace eerie::comparison
