#include "analysis/paper/impact_run.hpp"

#include <algorithm>
#include <cmath>

namespace eerie::paper {

std::vector<RidgeCell> ridge_cells(const std::vector<ImpactRun>& runs) {
  std::vector<RidgeCell> cells;
  for (const ImpactRun& run : runs) {
    const auto same = [&](const RidgeCell& cell) {
      return std::abs(cell.v_imp_cm_per_s - run.v_imp_cm_per_s) <= same_v_cm_per_s &&
             std::abs(cell.theta_imp_deg - run.theta_imp_deg) <= same_theta_deg;
    };
    auto at = std::ranges::find_if(cells, same);
    if (at == cells.end())
      at = cells.insert(cells.end(), {run.v_imp_cm_per_s, run.theta_imp_deg, {}});
    at->b_over_a.push_back(run.b_over_a());
  }
  return cells;
}

}  // namespace eerie::paper
