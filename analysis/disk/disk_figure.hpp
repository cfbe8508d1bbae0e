#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "analysis/disk/contours.hpp"
#include "analysis/drawing/script.hpp"

namespace eerie::disk {

/// Speeds over the distance from the star (across) and one other quantity (up), as contours.
struct DiskFigure {
  std::string title, y_label;  ///< the label with its unit
  double y_unit = 1;           ///< SI value of that unit
  std::vector<Contours>
      laws;  ///< one or two; the first is drawn solid and filled, the other dashed
  /// Limits for 40 cm/s as the paper's text gives them: lines of distance (m) and value (SI).
  std::vector<std::vector<std::pair<double, double>>> published;
};

/// As Figs. 7 and 8 of Sugiura et al. (2019). Two laws where the published one knows the body.
/// Throws InputError as drag_of.
DiskFigure turbulence_figure(DragLaw law, const Body& body, double r_low, double r_high);
DiskFigure stirring_figure(DragLaw law, const Body& body, const Stirrers& stirrers, double r_low,
                           double r_high);

/// gnuplot's commands for it, terminal apart.
drawing::Script disk_script(const DiskFigure& figure);

/// Nine centimetres wide; the extension decides: .png, .svg, .pdf. Throws InputError (another
/// extension) and EnvironmentError (gnuplot or the disk failed).
void draw_disk(const std::filesystem::path& path, const DiskFigure& figure);

}  // namespace eerie::disk
