#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/paper/facts.hpp"
#include "analysis/paper/impact_run.hpp"

namespace eerie::paper {

/// The runs of one impact of the paper.
struct CheckCell {
  ImpactPoint at;
  std::vector<const ImpactRun*> runs;

  using Condition = std::function<bool(const ImpactRun&)>;
  std::size_t count(const Condition& condition) const;
  /// Whether at least half of the runs, and at least one, have a property.
  bool mostly(const Condition& condition) const;
  /// Whether some runs, but not all, have a property.
  bool split(const Condition& condition) const;
};

/// The runs of a fact's mass ratio and friction angle at each of these points.
std::vector<CheckCell> check_cells(const std::vector<ImpactPoint>& points, const Fact& fact,
                                   const std::vector<ImpactRun>& runs);

bool largest_is_eer(const ImpactRun& run);
/// Whether some remnant other than the largest is an EER.
bool smaller_is_eer(const ImpactRun& run);
/// Whether M_lr >= 0.9 M, as for a perfect merger.
bool almost_merged(const ImpactRun& run);

/// The shell commands that add the missing runs: those of the fact's sweeps, or of its point with
/// seeds 1 to `seeds`. They use the fidelity of the settings (survey where these have none).
/// `changes` are further options, "--set PATH=VALUE ...".
std::string run_sweeps(const Fact& fact, const RunSettings& settings, const std::string& database,
                       const std::string& changes = "");
std::string run_point(const Fact& fact, const ImpactPoint& at, std::size_t seeds,
                      const RunSettings& settings, const std::string& database,
                      const std::string& changes = "");

}  // namespace eerie::paper
