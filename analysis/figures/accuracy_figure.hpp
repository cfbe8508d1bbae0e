#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/drawing/script.hpp"

namespace eerie::figures {

/// One setting of the solver, as a point of error against cost.
struct AccuracyPoint {
  struct Error {
    double error = 0, noise = 0;
  };
  std::string label;
  double core_seconds = 0;    ///< per impact
  std::vector<Error> errors;  ///< one per panel
  /// Whether it has all impacts; others get a ring and are not part of the frontier.
  bool whole = true;
  std::string name;  ///< name written beside the point; empty: none
};

/// A knob. A line joins its settings, the default included, in the order of their cost.
struct AccuracySeries {
  std::string name;
  bool is_default = false;  ///< the setting from which all knobs start, drawn as a star
  std::vector<AccuracyPoint> points;
};

/// The errors of several quantities against the cost of an impact, on logarithmic axes. Each panel
/// shows its Pareto frontier: the points that no other point beats in both. Bars show the noise.
/// Errors below a tenth of their noise are drawn at a tenth of it.
struct AccuracyFigure {
  std::vector<std::string> panels;  ///< the quantity of each panel
  std::vector<AccuracySeries> series;
  std::string title;
};

/// The gnuplot commands for the figure, without the terminal line. Throws InputError where there is
/// no point or no default.
drawing::Script accuracy_script(const AccuracyFigure& figure);

/// Draws the figure at `path`. The extension names the format: .svg, .png or .pdf. Throws
/// InputError and EnvironmentError as run_gnuplot() does.
void draw_accuracy(const std::filesystem::path& path, const AccuracyFigure& figure);

}  // namespace eerie::figures
