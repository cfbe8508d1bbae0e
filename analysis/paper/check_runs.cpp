#include "analysis/paper/check_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/text/shell_word.hpp"

namespace eerie::paper {

namespace {

std::string run_sweep(const std::string& sweep, const RunSettings& settings,
                      const std::string& database, const std::string& changes) {
  return fmt::format("eerie run {} --db {} --fidelity {}{}{}", sweep, shell_word(database),
                     settings.fidelity.empty() ? "survey" : settings.fidelity,
                     changes.empty() ? "" : " ", changes);
}

}  // namespace

std::size_t CheckCell::count(const Condition& condition) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(runs, [&](const ImpactRun* run) { return condition(*run); }));
}

bool CheckCell::mostly(const Condition& condition) const {
  return !runs.empty() && 2 * count(condition) >= runs.size();
}

bool CheckCell::split(const Condition& condition) const {
  const std::size_t those = count(condition);
  return those > 0 && those < runs.size();
}

std::vector<CheckCell> check_cells(const std::vector<ImpactPoint>& points, const Fact& fact,
                                   const std::vector<ImpactRun>& runs) {
  std::vector<CheckCell> cells;
  for (const ImpactPoint& point : points) {
    CheckCell cell{point, {}};
    for (const ImpactRun& run : runs)
      if (std::abs(run.q - fact.q) <= same_q &&
          std::abs(run.phi_d_deg - fact.phi_d_deg) <= same_phi_d_deg &&
          std::abs(run.v_imp_cm_per_s - point.v_imp_cm_per_s) <= same_v_cm_per_s &&
          std::abs(run.theta_imp_deg - point.theta_imp_deg) <= same_theta_deg)
        cell.runs.push_back(&run);
    cells.push_back(std::move(cell));
  }
  return cells;
}

bool largest_is_eer(const ImpactRun& run) {
  return !run.remnants.empty() && run.remnants.front().eer;
}

bool smaller_is_eer(const ImpactRun& run) {
  return std::ranges::any_of(run.remnants, [](const RunRemnant& r) { return r.rank > 1 && r.eer; });
}

bool almost_merged(const ImpactRun& run) {
  return run.m_lr_over_m_total >= remnants::perfect_merging_m_lr_over_m_total;
}

std::string run_sweeps(const Fact& fact, const RunSettings& settings, const std::string& database,
                       const std::string& changes) {
  std::string commands;
  for (const PaperGrid& grid : fact.grids)
    commands +=
        (commands.empty() ? "" : " && ") + run_sweep(grid.sweep(), settings, database, changes);
  return commands;
}

std::string run_point(const Fact& fact, const ImpactPoint& at, std::size_t seeds,
                      const RunSettings& settings, const std::string& database,
                      const std::string& changes) {
  std::string list = "1";
  for (std::size_t seed = 2; seed <= seeds; ++seed) list += fmt::format(",{}", seed);
  const std::string name = changes.empty()
                               ? fmt::format("check-q{:g}-phi{:g}-v{:g}-theta{:g}", fact.q,
                                             fact.phi_d_deg, at.v_imp_cm_per_s, at.theta_imp_deg)
                               : "check-" + fact.name;
  return fmt::format(
      "echo "
      "'{{\"name\":\"{0}\",\"grid\":{{\"q\":[{1}],\"phi_d_deg\":[{2}],\"v_imp_cm_per_s\":[{3}],"
      "\"theta_imp_deg\":[{4}],\"numerics.seed\":[{5}]}}}}' > {0}.json && {6}",
      name, fact.q, fact.phi_d_deg, at.v_imp_cm_per_s, at.theta_imp_deg, list,
      run_sweep(name + ".json", settings, database, changes));
}

}  // namespace eerie::paper
