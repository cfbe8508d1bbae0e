#include "analysis/phase_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/gnuplot.hpp"
#include "analysis/outcome.hpp"
#include "analysis/phase_script.hpp"
#include "solver/base/error.hpp"

namespace eerie {

namespace {

std::string_view state_name(CellState state) {
  switch (state) {
    case CellState::done:
      return "done";
    case CellState::unsettled:
      return "unsettled";
    case CellState::failed:
      return "failed";
    case CellState::pending:
      return "pending";
  }
  throw std::logic_error("unknown state of a cell");
}

bool has_result(const PhaseCell& cell) {
  return cell.state == CellState::done || cell.state == CellState::unsettled;
}

/// By angle, then by speed.
std::vector<PhaseCell> sorted(std::vector<PhaseCell> cells) {
  std::ranges::sort(
      cells, {}, [](const PhaseCell& c) { return std::pair(c.theta_imp_deg, c.v_imp_cm_per_s); });
  return cells;
}

void require_drawable(const PhaseDiagram& diagram) {
  if (diagram.cells.empty()) throw InputError("a map needs at least one impact; there is none");
  const std::vector<PhaseCell> cells = sorted(diagram.cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const PhaseCell& c = cells[i];
    const std::string where = fmt::format("map cell at v_imp = {:g} cm/s, theta_imp = {:g} deg",
                                          c.v_imp_cm_per_s, c.theta_imp_deg);
    if (!std::isfinite(c.v_imp_cm_per_s) || !std::isfinite(c.theta_imp_deg))
      throw InputError(where + ": speed and angle must be finite");
    if (i > 0 && c.v_imp_cm_per_s == cells[i - 1].v_imp_cm_per_s &&
        c.theta_imp_deg == cells[i - 1].theta_imp_deg)
      throw InputError(where + " is there twice: choose one q, phi_d, resolution and seed");
    if (!has_result(c)) continue;
    if (!(c.b_over_a >= 0 && c.b_over_a <= 1))
      throw InputError(fmt::format("{}: b/a = {} must be from 0 to 1", where, c.b_over_a));
    if (!outcome_named(c.outcome))
      throw InputError(fmt::format("{}: '{}' is no outcome class", where, c.outcome));
  }
}

}  // namespace

void draw_phase_diagram(const std::filesystem::path& path, const PhaseDiagram& diagram) {
  require_drawable(diagram);
  const FigureScript figure = phase_script(diagram);
  run_gnuplot(gnuplot_terminal(path, figure.width_pt, figure.height_pt) + figure.commands, path);
}

std::string phase_diagram_csv(const PhaseDiagram& diagram) {
  std::string text =
      "q,phi_d_deg,particles_per_target,v_imp_cm_per_s,theta_imp_deg,v_imp_over_v_esc,state,"
      "outcome,b_over_a,eer\n";
  for (const PhaseCell& c : sorted(diagram.cells)) {
    text += fmt::format("{},{},{},{},{},", diagram.q, diagram.phi_d_deg,
                        diagram.particles_per_target, c.v_imp_cm_per_s, c.theta_imp_deg);
    if (diagram.v_esc_cm_per_s > 0)
      text += fmt::format("{:.4f}", c.v_imp_cm_per_s / diagram.v_esc_cm_per_s);
    text += fmt::format(",{},", state_name(c.state));
    text += has_result(c) ? fmt::format("{},{:.4f},{:d}\n", c.outcome, c.b_over_a, c.eer) : ",,\n";
  }
  return text;
}

}  // namespace eerie
