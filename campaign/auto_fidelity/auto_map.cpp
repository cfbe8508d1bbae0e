#include "campaign/auto_fidelity/auto_map.hpp"

#include <map>
#include <utility>

#include "analysis/paper/threshold.hpp"
#include "campaign/sweeps/job.hpp"

namespace eerie::auto_fidelity {

std::vector<diagrams::PhaseDiagram> phase_diagrams(const AutoFidelity& campaign) {
  std::map<std::pair<double, double>, diagrams::PhaseDiagram> diagrams;
  for (const AutoCell& c : campaign.cells()) {
    const Scene& s = c.scenes.front();
    const double q = s.impact.q, phi_d = s.material.drucker_prager.phi_d_deg;
    diagrams::PhaseDiagram& diagram = diagrams[{q, phi_d}];
    diagram.q = q, diagram.phi_d_deg = phi_d;
    diagram.v_esc_cm_per_s = 100 * sweeps::mutual_escape_speed(s);
    diagram.threshold_cm_per_s = paper::published_threshold(q, phi_d);
    diagrams::PhaseCell cell{s.impact.v_imp_cm_per_s, s.impact.theta_imp_deg};
    if (c.is_known()) {
      cell.state = diagrams::CellState::done;
      cell.b_over_a = c.verdict.b_over_a, cell.outcome = c.verdict.outcome;
      cell.fidelity = campaign.fidelity(c), cell.seeds = c.seeds();
      cell.in_doubt = campaign.in_doubt(c);
    }
    diagram.cells.push_back(std::move(cell));
  }
  std::vector<diagrams::PhaseDiagram> all;
  for (auto& [point, diagram] : diagrams) all.push_back(std::move(diagram));
  return all;
}

}  // namespace eerie::auto_fidelity
