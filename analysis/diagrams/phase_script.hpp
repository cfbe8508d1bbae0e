#pragma once

#include "analysis/diagrams/phase_diagram.hpp"
#include "analysis/drawing/script.hpp"

namespace eerie::diagrams {

/// The gnuplot commands of a figure, without the terminal line, and its size in points.
struct FigureScript {
  double width_pt = 0, height_pt = 0;
  drawing::Script commands;
};

/// Lays out a figure for print (phase_layout.hpp). The caller has checked it.
FigureScript phase_script(const PhaseFigure& figure);

}  // namespace eerie::diagrams
