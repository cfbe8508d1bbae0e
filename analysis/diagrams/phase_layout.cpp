#include "analysis/diagrams/phase_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "analysis/drawing/grouped.hpp"

namespace eerie::diagrams {

namespace {

// All in points; 255 points are 9 cm, 525 are 18.5 cm.
constexpr double column_width = 255, whole_width = 525;
constexpr double left = 34, beside_none = 10, between = 9;
constexpr double page_title = 14, panel_title = 11, axis_above = 22, axis_below = 24, below = 5;
constexpr double longest_bar = 180;

std::size_t panel_count(const PhaseFigure& figure) {
  return figure.diagrams.size() * figure.quantities.size();
}

std::size_t columns_of(std::size_t panels) { return panels <= 3 ? 1 : panels <= 8 ? 2 : 3; }

double panel_height(std::size_t panels) { return panels == 1 ? 150 : panels <= 8 ? 128 : 104; }

drawing::Quoted of_settings(const PhaseDiagram& d) {
  if (d.particles_per_target == 0) return {};
  return drawing::in_quotes(fmt::format("{}{}{} particles per target", d.fidelity,
                                        d.fidelity.empty() ? "" : ": ",
                                        drawing::grouped(d.particles_per_target)));
}

drawing::Quoted joined(const drawing::Quoted& a, const drawing::Quoted& b) {
  return a + drawing::in_quotes(a.empty() || b.empty() ? "" : ",  ") + b;
}

/// The same constant in all panels stands in the legend.
bool curves_differ(const PhaseFigure& figure) {
  return std::ranges::any_of(figure.diagrams, [&](const PhaseDiagram& d) {
    return d.threshold_cm_per_s != figure.diagrams.front().threshold_cm_per_s;
  });
}

PanelFrame frame_of(const PhaseDiagram& diagram) {
  const CellGrid grid(diagram);
  return {grid.v.edges.front(),
          grid.v.edges.back(),
          grid.theta.edges.front(),
          grid.theta.edges.back(),
          {}};
}

/// Borders that hold the cells of all diagrams.
PanelFrame common_frame(const PhaseFigure& figure) {
  PanelFrame frame = frame_of(figure.diagrams.front());
  for (const PhaseDiagram& diagram : figure.diagrams) {
    const PanelFrame one = frame_of(diagram);
    frame.v_low = std::min(frame.v_low, one.v_low);
    frame.v_high = std::max(frame.v_high, one.v_high);
    frame.theta_low = std::min(frame.theta_low, one.theta_low);
    frame.theta_high = std::max(frame.theta_high, one.theta_high);
  }
  return frame;
}

/// Common axes would leave more than a third of some panel blank.
bool axes_differ(const PhaseFigure& figure) {
  const auto size = [](const PanelFrame& f) {
    return (f.v_high - f.v_low) * (f.theta_high - f.theta_low);
  };
  const double common = size(common_frame(figure));
  return std::ranges::any_of(
      figure.diagrams, [&](const PhaseDiagram& d) { return size(frame_of(d)) < 0.65 * common; });
}

/// Letters stand once in a figure: in the panel of classes, else in the first. They would hide
/// borders.
bool has_letters(const PhaseFigure& figure, MapQuantity quantity) {
  if (quantity == MapQuantity::p_largest_eer &&
      std::ranges::any_of(figure.diagrams, [](const auto& d) { return d.borders.has_value(); }))
    return false;
  const bool classes = std::ranges::count(figure.quantities, MapQuantity::outcome) > 0;
  return quantity == (classes ? MapQuantity::outcome : figure.quantities.front());
}

std::vector<PhasePanel> panels_of(const PhaseFigure& figure, bool own_axes) {
  std::vector<PhaseCell> cells;
  for (const PhaseDiagram& d : figure.diagrams)
    cells.insert(cells.end(), d.cells.begin(), d.cells.end());
  std::vector<PhasePanel> panels;
  for (const MapQuantity quantity : figure.quantities)
    for (const PhaseDiagram& d : figure.diagrams) {
      PhasePanel panel;
      panel.diagram = &d, panel.scale = map_scale(quantity, cells);
      panel.frame = own_axes ? frame_of(d) : common_frame(figure);
      panel.letters = has_letters(figure, quantity);
      panel.bar = quantity != MapQuantity::outcome && figure.diagrams.size() == 1;
      if (figure.diagrams.size() > 1) {
        panel.title = name_of_place(d);
        if (curves_differ(figure) && d.threshold_cm_per_s)
          panel.title =
              panel.title + drawing::marked_up(",  v sin θ = {:g} cm/s", *d.threshold_cm_per_s);
      } else if (figure.quantities.size() > 1 && quantity == MapQuantity::outcome) {
        panel.title = drawing::marked_up("{}", name_of(quantity).title);
      }
      panels.push_back(std::move(panel));
    }
  return panels;
}

}  // namespace

double bar_title_distance(const MapScale& scale) {
  double widest = 0;
  for (const double tick : scale.ticks)
    widest = std::max(widest, drawing::text_width(drawing::marked_up("{:g}", tick), tick_size));
  return 8 + widest;
}

// The spaces beside subscripts do not break: SVG viewers drop ordinary ones.
drawing::Quoted name_of_place(const PhaseDiagram& d) {
  return drawing::marked_up("q = {:g},  φ_d\u00a0= {:g}°", d.q, d.phi_d_deg);
}

double phase_page_width(const PhaseFigure& figure) {
  return columns_of(panel_count(figure)) == 1 ? column_width : whole_width;
}

PhaseLayout phase_layout(const PhaseFigure& figure, double legend_height) {
  PhaseLayout page;
  page.width = phase_page_width(figure);
  page.own_axes = axes_differ(figure);
  page.panels = panels_of(figure, page.own_axes);
  const std::size_t count = page.panels.size(), columns = columns_of(count),
                    rows = (count + columns - 1) / columns;
  const PhaseDiagram& first = figure.diagrams.front();
  page.title = figure.diagrams.size() > 1 ? of_settings(first)
                                          : joined(name_of_place(first), of_settings(first));
  page.shared_bar = figure.diagrams.size() > 1 && figure.quantities.front() != MapQuantity::outcome;
  const bool bars = std::ranges::any_of(page.panels, &PhasePanel::bar);
  const bool speeds_differ = std::ranges::any_of(figure.diagrams, [&](const PhaseDiagram& d) {
    return std::abs(d.v_esc_cm_per_s - first.v_esc_cm_per_s) > 1e-6 * first.v_esc_cm_per_s;
  });

  double beside_bar = 0;
  for (const PhasePanel& p : page.panels)
    beside_bar = std::max(beside_bar, bar_gap + bar_width + bar_title_distance(p.scale) + 5);
  const double right = bars || page.shared_bar ? beside_bar : beside_none;
  const double inner = (bars ? beside_bar : 0) + (page.own_axes ? left : between);
  const auto n = static_cast<double>(columns);
  const double width = (page.width - left - right - (n - 1) * inner) / n;
  const double height = panel_height(count);

  // From the top downwards, turned over once the height is known.
  double down = page.title.empty() ? 4 : page_title;
  for (std::size_t row = 0; row < rows; ++row) {
    const bool above = row == 0 || speeds_differ || page.own_axes;
    const std::span<PhasePanel> those = std::span(page.panels)
                                            .subspan(row * columns)
                                            .first(std::min(columns, count - row * columns));
    const bool titles =
        std::ranges::any_of(those, [](const PhasePanel& p) { return !p.title.empty(); });
    down += (titles ? panel_title : 0) + (above && first.v_esc_cm_per_s > 0 ? axis_above : below);
    bool last_of_column = false;
    for (std::size_t column = 0; column < those.size(); ++column) {
      PhasePanel& p = those[column];
      const double x = left + static_cast<double>(column) * (width + inner);
      p.frame.area = {{x, -(down + height)}, {x + width, -down}};
      p.labels_left = column == 0 || page.own_axes;
      p.labels_below = (row + 1) * columns + column >= count || page.own_axes;
      p.labels_above = above && p.diagram->v_esc_cm_per_s > 0;
      last_of_column = last_of_column || p.labels_below;
    }
    down += height + (last_of_column ? axis_below : below);
  }
  page.height = down + legend_height + 6;
  for (PhasePanel& p : page.panels)
    p.frame.area.low.y += page.height, p.frame.area.high.y += page.height;
  if (count % columns != 0) {
    const drawing::Area& last = page.panels.back().frame.area;
    page.gap = {{last.high.x + inner, last.low.y}, {page.width - right, last.high.y}};
  }
  page.legend = {legend_margin, legend_height + 4};
  if (page.shared_bar) {
    const double x = page.width - right + bar_gap;
    const double top = page.panels.front().frame.area.high.y,
                 bottom = page.panels.back().frame.area.low.y, middle = (top + bottom) / 2;
    const double half = std::min(longest_bar, top - bottom) / 2;
    page.bar = {{x, middle - half}, {x + bar_width, middle + half}};
  }
  return page;
}

}  // namespace eerie::diagrams
