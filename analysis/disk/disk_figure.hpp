#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "analysis/disk/contours.hpp"
#include "analysis/drawing/script.hpp"

namespace eerie::disk {

/// Contours of speed over the distance from the star (across) and one other quantity (up).
struct DiskFigure {
  std::string title, y_label;  ///< the label with its unit
  double y_unit = 1;           ///< the SI value of that unit
  std::vector<Contours> laws;  ///< one or two; the first is solid and filled, the other dashed
  /// The limits for 40 cm/s in the text of the paper, as lines of distance (m) and value (SI).
  std::vector<std::vector<std::pair<double, double>>> published;
};

/// Figs. 7 and 8 of Sugiura et al. (2019). They have two laws where the published law knows the
/// body. Throws InputError as drag_of() does.
DiskFigure turbulence_figure(DragLaw law, const Body& body, double r_low, double r_high);
DiskFigure stirring_figure(DragLaw law, const Body& body, const Stirrers& stirrers, double r_low,
                           double r_high);

/// The gnuplot commands for the figure, without the terminal line.
drawing::Script disk_script(const DiskFigure& figure);

/// Draws the figure, nine centimetres wide. The extension names the format: .png, .svg or .pdf.
/// Throws InputError (another extension) and EnvironmentError (gnuplot or the disk fails).
void draw_disk(const std::filesystem::path& path, const DiskFigure& figure);

}  // namespace eerie::disk
