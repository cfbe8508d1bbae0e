#include "analysis/diagrams/phase_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/diagrams/phase_script.hpp"
#include "analysis/drawing/gnuplot.hpp"
#include "analysis/remnants/outcome.hpp"
#include "solver/base/error.hpp"

namespace eerie::diagrams {

namespace {

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
    if (!c.has_result()) continue;
    if (c.b_over_a && !(*c.b_over_a >= 0 && *c.b_over_a <= 1))
      throw InputError(fmt::format("{}: b/a = {} must be from 0 to 1", where, *c.b_over_a));
    if (!remnants::outcome_named(c.outcome))
      throw InputError(fmt::format("{}: '{}' is no outcome class", where, c.outcome));
  }
}

void require_drawable(const PhaseFigure& figure) {
  const std::size_t diagrams = figure.diagrams.size(), quantities = figure.quantities.size();
  if (diagrams == 0 || quantities == 0)
    throw InputError("a map needs at least one impact and one quantity; there is none");
  if (diagrams > 1 && quantities > 1)
    throw InputError(
        fmt::format("{} quantities at {} mass ratios and friction angles are too much for one "
                    "figure; choose one quantity, or one mass ratio and friction angle",
                    quantities, diagrams));
  if (diagrams * quantities > most_panels)
    throw InputError(fmt::format("{} panels are too many for one figure, {} are the most",
                                 diagrams * quantities, most_panels));
  for (const PhaseDiagram& diagram : figure.diagrams) require_drawable(diagram);
}

}  // namespace

void draw_phase_figure(const std::filesystem::path& path, const PhaseFigure& figure) {
  require_drawable(figure);
  const FigureScript script = phase_script(figure);
  drawing::run_gnuplot(
      drawing::gnuplot_terminal(path, script.width_pt, script.height_pt) + script.commands, path);
}

void draw_phase_diagram(const std::filesystem::path& path, const PhaseDiagram& diagram) {
  draw_phase_figure(path, {{diagram}});
}

}  // namespace eerie::diagrams
