#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/drawing/script.hpp"

namespace eerie::figures {

/// One setting of the solver on a chart of error against cost.
struct AccuracyPoint {
  struct Error {
    double error = 0, noise = 0;
  };
  std::string label;
  double core_seconds = 0;    ///< per impact
  std::vector<Error> errors;  ///< one per panel
  bool whole = true;          ///< of all impacts; others are ringed and no part of the frontier
  std::string name;           ///< written beside it; none where empty
};

/// A knob: its settings are joined in the order of their cost, with the default among them.
struct AccuracySeries {
  std::string name;
  bool is_default = false;  ///< the setting that all knobs start from: a star
  std::vector<AccuracyPoint> points;
};

/// Errors of several quantities against the cost of an impact, both logarithmic, with the Pareto
/// frontier of each panel: what nothing beats in both. Bars are the noise; errors below a tenth of
/// their noise are drawn there.
struct AccuracyFigure {
  std::vector<std::string> panels;  ///< what errs
  std::vector<AccuracySeries> series;
  std::string title;
};

/// gnuplot's commands for the figure, without its terminal. Throws InputError where there is no
/// point or no default.
drawing::Script accuracy_script(const AccuracyFigure& figure);

/// Draws it at `path`; the extension decides: .svg, .png, .pdf. Throws InputError and
/// EnvironmentError as run_gnuplot() does.
void draw_accuracy(const std::filesystem::path& path, const AccuracyFigure& figure);

}  // namespace eerie::figures
