#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/drawing/script.hpp"

namespace eerie::figures {

/// An ensemble at one particle number, or one run at one time.
struct ConvergencePoint {
  double at = 0;                   ///< particle number, or time in 1,000 s
  double mean = 0, deviation = 0;  ///< standard deviation of a single run
  double low = 0, high = 0;        ///< extremes of the ensemble; tables have them
};

/// A panel: one quantity against particle number or time.
struct ConvergencePanel {
  std::string label;                                  ///< label of the axis, with unit
  std::optional<double> published;                    ///< published value, drawn as a dashed line
  std::vector<std::vector<ConvergencePoint>> series;  ///< in the order of ConvergenceFigure::series
  bool logarithmic = false;  ///< logarithmic axis of values; leaves out 0 and below
  /// The means at another time, in the order of `series`, drawn as open marks. May be empty.
  std::vector<std::vector<ConvergencePoint>> earlier = {};
};

struct ConvergenceFigure {
  std::string title;
  std::vector<std::string> series;  ///< names, six at most
  std::vector<ConvergencePanel> panels;
  bool over_time = false;    ///< curves of single runs instead of ensembles
  std::string earlier = {};  ///< the meaning of open marks: "at 100000 s"
};

/// Draws panels below each other, nine centimetres wide: means, with standard deviations of a
/// single run as bars. Series without points and panels without curves do not appear. The extension
/// names the format: .png, .svg or .pdf. Throws InputError (no point at all, another extension) and
/// EnvironmentError (gnuplot or the disk fails).
void draw_convergence(const std::filesystem::path& path, const ConvergenceFigure& figure);

/// The gnuplot commands for the figure, without the terminal line.
drawing::Script convergence_script(const ConvergenceFigure& figure);

}  // namespace eerie::figures
