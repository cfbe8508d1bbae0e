#include "analysis/paper/finest_runs.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "analysis/paper/check.hpp"
#include "analysis/paper/check_runs.hpp"

namespace eerie::paper {

namespace {

using ByKind = std::map<RunSettings, std::vector<const ImpactRun*>>;

ByKind by_kind(const CheckCell& cell) {
  ByKind kinds;
  for (const ImpactRun* run : cell.runs)
    if (run->stiffness == 1) kinds[run->settings].push_back(run);
  return kinds;
}

bool may_replace(const RunSettings& finer, const RunSettings& base) {
  const auto is_rung = [](const RunSettings& s) {
    return !s.fidelity.empty() && s.fidelity != "paper";
  };
  return is_rung(finer) && is_rung(base) && finer.particles_per_target > base.particles_per_target;
}

/// The runs of one impact that count; empty where there are none.
std::vector<const ImpactRun*> those_that_count(ByKind&& kinds, const RunSettings& base) {
  std::erase_if(kinds, [&](const auto& kind) {
    return kind.first != base && !may_replace(kind.first, base);
  });
  std::size_t most = 0;
  for (const auto& [settings, runs] : kinds) most = std::max(most, runs.size());
  const std::size_t enough = std::min(most, check_min_runs);
  for (auto kind = kinds.rbegin(); kind != kinds.rend(); ++kind)  // the most particles first
    if (kind->second.size() >= enough) return std::move(kind->second);
  return {};
}

}  // namespace

std::vector<RunSettings> by_coverage(const Fact& fact, const std::vector<ImpactRun>& runs) {
  std::map<RunSettings, std::size_t> impacts;
  for (const CheckCell& cell : check_cells(points_of(fact.grids), fact, runs))
    for (const auto& [settings, some] : by_kind(cell)) ++impacts[settings];
  std::vector<std::pair<std::size_t, RunSettings>> order;
  order.reserve(impacts.size());
  for (const auto& [settings, count] : impacts) order.emplace_back(count, settings);
  std::ranges::sort(order, std::greater{});
  std::vector<RunSettings> all;
  all.reserve(order.size());
  for (auto& [count, settings] : order) all.push_back(std::move(settings));
  return all;
}

std::vector<ImpactRun> finest_runs(const Fact& fact, const std::vector<ImpactRun>& runs,
                                   const RunSettings& base) {
  std::vector<ImpactRun> counting;
  for (const CheckCell& cell : check_cells(points_of(fact.grids), fact, runs))
    for (const ImpactRun* run : those_that_count(by_kind(cell), base)) counting.push_back(*run);
  return counting;
}

}  // namespace eerie::paper
