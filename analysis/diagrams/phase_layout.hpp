#pragma once

#include <vector>

#include "analysis/diagrams/phase_cells.hpp"

namespace eerie::diagrams {

/// One panel of a figure, in points on the page.
struct PhasePanel {
  const PhaseDiagram* diagram = nullptr;
  MapScale scale;
  PanelFrame frame;
  drawing::Quoted title = {};  ///< empty: the figure's says it
  bool labels_left = true, labels_below = true, labels_above = true;
  bool bar = true;  ///< a colour bar of its own on its right
};

/// Where everything stands. One map, or up to three below one another, are as wide as a column of a
/// journal; more panels as wide as its page.
struct PhaseLayout {
  double width = 0, height = 0;
  drawing::Quoted title;
  std::vector<PhasePanel> panels;
  bool shared_bar = false;
  drawing::Area bar = {};      ///< of the shared colour bar
  drawing::Point legend = {};  ///< its upper left corner
};

inline constexpr double tick_size = 6.5, bar_gap = 8, bar_width = 7, legend_margin = 8;
/// From a colour bar to the middle of its title, beyond its ticks.
double bar_title_distance(const MapScale& scale);

double phase_page_width(const PhaseFigure& figure);
/// `legend_height`: of a legend as wide as the page but for its margins.
PhaseLayout phase_layout(const PhaseFigure& figure, double legend_height);

}  // namespace eerie::diagrams
