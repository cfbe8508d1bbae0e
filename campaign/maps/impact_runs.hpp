#pragma once

#include <vector>

#include "analysis/paper/impact_run.hpp"
#include "db/views/query.hpp"

namespace eerie::maps {

/// The results of a database as runs of the paper's impacts, and the numbers of results that are
/// left out.
struct ImpactRuns {
  std::vector<paper::ImpactRun> runs;
  /// The number of runs whose remnants will meet again. They count like others, as did the paper's
  /// runs at the end of their time.
  std::size_t unsettled = 0;
  std::size_t stale = 0;         ///< from another solver version than that of the database
  std::size_t other_bodies = 0;  ///< with another radius, material or environment than the paper's
};

/// Collects the runs of a filter. Bodies are the paper's where target, material and environment are
/// the defaults of a scene; friction angle and stiffness (A and B times one number) are free.
ImpactRuns impact_runs(const db::Connection& connection, const db::ResultFilter& filter);

/// Runs with the same mass ratio, friction angle and settings, and the paper's stiffness.
struct ComparableRuns {
  double q = 1, phi_d_deg = 40;
  paper::RunSettings settings;
  std::vector<paper::ImpactRun> runs;
};
std::vector<ComparableRuns> groups_of(const std::vector<paper::ImpactRun>& runs);

/// A remark about unsettled runs and results that are left out; empty where there are none.
std::string remark(const ImpactRuns& runs);

}  // namespace eerie::maps
