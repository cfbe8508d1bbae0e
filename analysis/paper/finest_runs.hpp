#pragma once

#include <vector>

#include "analysis/paper/facts.hpp"
#include "analysis/paper/impact_run.hpp"

namespace eerie::paper {

/// The settings of the runs that concern a fact on a grid: those with runs at the most impacts come
/// first, and of equals those with the most particles.
std::vector<RunSettings> by_coverage(const Fact& fact, const std::vector<ImpactRun>& runs);

/// The runs that count for a fact on a grid: those of `base`, and in their place, impact by impact,
/// those of the finest named fidelity that has enough of them. These are check_min_runs, or as many
/// as any has there. Runs of stiffer bodies, and of the fidelity "paper", whose scheme is another,
/// take no other's place.
std::vector<ImpactRun> finest_runs(const Fact& fact, const std::vector<ImpactRun>& runs,
                                   const RunSettings& base);

}  // namespace eerie::paper
