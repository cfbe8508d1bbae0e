#pragma once

#include <optional>
#include <vector>

#include "analysis/diagrams/phase_cells.hpp"

namespace eerie::diagrams {

/// One panel of a figure, in points on the page.
struct PhasePanel {
  const PhaseDiagram* diagram = nullptr;
  MapScale scale;
  PanelFrame frame;
  drawing::Quoted title = {};  ///< empty where the title of the figure suffices
  bool labels_left = true, labels_below = true, labels_above = true;
  bool bar = true;      ///< whether it has its own colour bar on the right
  bool letters = true;  ///< whether its cells show the letters of classes
};

/// The positions of everything in a figure. Up to three panels stand below one another and are as
/// wide as a column of a journal. More panels are as wide as its page.
struct PhaseLayout {
  double width = 0, height = 0;
  drawing::Quoted title;
  std::vector<PhasePanel> panels;
  bool shared_bar = false;
  drawing::Area bar = {};      ///< area of the shared colour bar
  drawing::Point legend = {};  ///< its upper left corner
  /// Where the last row has no panels.
  std::optional<drawing::Area> gap = {};
  bool own_axes = false;  ///< panels have axes of their own
};

inline constexpr double tick_size = 6.5, bar_gap = 8, bar_width = 7, legend_margin = 8;
/// The distance from a colour bar to the middle of its title, beyond its ticks.
double bar_title_distance(const MapScale& scale);

double phase_page_width(const PhaseFigure& figure);
/// "q = 1, phi_d = 40 deg"
drawing::Quoted name_of_place(const PhaseDiagram& diagram);
/// `legend_height` is that of a legend as wide as the page without its margins.
PhaseLayout phase_layout(const PhaseFigure& figure, double legend_height);

}  // namespace eerie::diagrams
