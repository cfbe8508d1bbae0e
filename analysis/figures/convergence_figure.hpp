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
  double mean = 0, deviation = 0;  ///< standard deviation of single runs
  double low = 0, high = 0;        ///< extremes of the ensemble
};

/// One quantity against particle number or time.
struct ConvergencePanel {
  std::string label;                                  ///< of the axis, with unit
  std::optional<double> published;                    ///< drawn as a dashed line
  std::vector<std::vector<ConvergencePoint>> series;  ///< as ConvergenceFigure::series
  bool logarithmic = false;                           ///< its values; 0 and less are left out
  /// Means at another time, as `series`, drawn as open marks; may be empty.
  std::vector<std::vector<ConvergencePoint>> earlier = {};
};

struct ConvergenceFigure {
  std::string title;
  std::vector<std::string> series;  ///< names, six at most
  std::vector<ConvergencePanel> panels;
  bool over_time = false;    ///< curves of single runs in place of ensembles
  std::string earlier = {};  ///< what open marks are: "at 100000 s"
};

/// Draws panels below each other, nine centimetres wide: means with standard deviations (thick)
/// and extremes (thin). The extension decides: .png, .svg, .pdf. Throws InputError (no point at
/// all, another extension) and EnvironmentError (gnuplot or the disk failed).
void draw_convergence(const std::filesystem::path& path, const ConvergenceFigure& figure);

/// gnuplot's commands for it, terminal apart.
drawing::Script convergence_script(const ConvergenceFigure& figure);

}  // namespace eerie::figures
