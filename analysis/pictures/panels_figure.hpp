#pragma once

#include <filesystem>
#include <vector>

#include "analysis/drawing/script.hpp"
#include "analysis/pictures/particle_view.hpp"

namespace eerie::pictures {

/// One moment, drawn.
struct Panel {
  double time = 0;          ///< s
  Bitmap image;             ///< panel_pixels() wide and high
  std::size_t outside = 0;  ///< remnants that the frame does not show
};

/// Panels of one scale, from left to right and from the top down.
struct PanelsFigure {
  std::vector<Panel> panels;
  double frame_width = 0;  ///< m
  ColourScale scale;
};

/// Pixels of a panel where there are so many: 360 per inch in print.
int panel_pixels(std::size_t panels);

/// The figure in the format that the extension names (.png, .svg, .pdf): up to three panels as wide
/// as a column of a journal (9 cm), more as wide as its page (18 cm), five in a row. Particles are
/// pixels in every format, so that the file does not grow with their number; words are words.
/// Throws InputError (no panels, another extension) and EnvironmentError (gnuplot or the disk).
void draw_panels(const std::filesystem::path& path, const PanelsFigure& figure);

/// gnuplot's commands for it, terminal apart, with the pixels of the panels inside.
drawing::Script panels_script(const PanelsFigure& figure);

}  // namespace eerie::pictures
