#include "analysis/paper/check.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/paper/check_runs.hpp"
#include "analysis/paper/fact_trial.hpp"
#include "analysis/paper/finest_runs.hpp"

namespace eerie::paper {

std::string_view name(Agreement agreement) {
  return agreement_names.at(static_cast<std::size_t>(agreement));
}

namespace {

FactCheck check_grid(const Fact& fact, const std::vector<ImpactRun>& runs,
                     const std::string& database) {
  std::optional<FactCheck> first;  // of the settings with the most impacts
  for (const RunSettings& base : by_coverage(fact, runs)) {
    const std::vector<ImpactRun> counting = finest_runs(fact, runs, base);
    FactCheck found = Trial(fact, counting, base, database).finding();
    if (found.agreement != Agreement::not_enough) return found;
    if (!first) first = found;
  }
  return first ? *first : Trial(fact, runs, {}, database).finding();
}

}  // namespace

FactCheck check(const Fact& fact, const std::vector<ImpactRun>& runs, const std::string& database) {
  if (!fact.point) return check_grid(fact, runs, database);
  std::set<RunSettings> kinds;  // the most particles last
  for (const ImpactRun& run : runs)
    if (std::abs(run.q - fact.q) <= same_q &&
        std::abs(run.phi_d_deg - fact.phi_d_deg) <= same_phi_d_deg)
      kinds.insert(run.settings);
  std::optional<FactCheck> best;
  for (auto kind = kinds.rbegin(); kind != kinds.rend(); ++kind) {
    std::vector<ImpactRun> same;
    std::ranges::copy_if(runs, std::back_inserter(same),
                         [&](const ImpactRun& run) { return run.settings == *kind; });
    FactCheck found = Trial(fact, same, *kind, database).finding();
    if (found.agreement != Agreement::not_enough) return found;
    if (!best || found.impacts > best->impacts) best = found;
  }
  return best ? *best : Trial(fact, runs, {}, database).finding();
}

}  // namespace eerie::paper
