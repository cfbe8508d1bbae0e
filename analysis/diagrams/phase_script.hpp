#pragma once

#include "analysis/diagrams/phase_diagram.hpp"
#include "analysis/drawing/script.hpp"

namespace eerie::diagrams {

/// A figure as gnuplot commands without the terminal line, and its size in points.
struct FigureScript {
  double width_pt = 0, height_pt = 0;
  drawing::Script commands;
};

/// Lays a figure out for print (phase_layout.hpp). It was checked by the caller.
FigureScript phase_script(const PhaseFigure& figure);

}  // namespace eerie::diagrams
