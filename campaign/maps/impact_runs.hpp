#pragma once

#include <vector>

#include "analysis/paper/impact_run.hpp"
#include "db/views/query.hpp"

namespace eerie::maps {

/// The results of a database as runs of the paper's impacts, and how many are left out and why.
struct ImpactRuns {
  std::vector<paper::ImpactRun> runs;
  /// Of the runs: remnants will meet again. They count as they stand, as the paper's runs did when
  /// their time was over.
  std::size_t unsettled = 0;
  std::size_t stale = 0;         ///< made by another solver version than the database's
  std::size_t other_bodies = 0;  ///< radius, material or surroundings are not the paper's
};

/// Bodies are the paper's when target, material and environment are the scene's defaults; friction
/// angle and stiffness (A = B times a number) are free.
ImpactRuns impact_runs(const db::Connection& connection, const db::ResultFilter& filter);

/// The runs by mass ratio, friction angle and settings; of the paper's stiffness only.
struct ComparableRuns {
  double q = 1, phi_d_deg = 40;
  paper::RunSettings settings;
  std::vector<paper::ImpactRun> runs;
};
std::vector<ComparableRuns> groups_of(const std::vector<paper::ImpactRun>& runs);

/// What is to be known of the runs: unsettled ones, and results left out; empty where there is
/// nothing.
std::string remark(const ImpactRuns& runs);

}  // namespace eerie::maps
