#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/drawing/script.hpp"
#include "analysis/pictures/particle_view.hpp"

namespace eerie::pictures {

/// The picture of one moment.
struct Panel {
  double time = 0;          ///< s
  Bitmap image;             ///< panel_pixels() wide and high
  std::size_t outside = 0;  ///< number of remnants outside the frame
  std::string name = {};    ///< what happens: "contact"; may be empty
};

/// Panels of one scale, from left to right and from the top down.
struct PanelsFigure {
  std::vector<Panel> panels;
  double frame_width = 0;  ///< m
  ColourScale scale;
  drawing::Quoted title = {};  ///< impact and settings; may be empty
};

/// The pixels along the side of a panel in a figure of so many panels: 360 per inch in print.
int panel_pixels(std::size_t panels);

/// Draws the figure in the format that the extension names (.png, .svg or .pdf). Up to three panels
/// are as wide as a column of a journal (9 cm), more panels as wide as its page (18 cm), five in a
/// row. Particles are pixels in every format, so the size of the file does not depend on their
/// number. Words stay text. Throws InputError (no panels, another extension) and EnvironmentError
/// (gnuplot or the disk fails).
void draw_panels(const std::filesystem::path& path, const PanelsFigure& figure);

/// The gnuplot commands for the figure with the pixels of the panels, without the terminal line.
drawing::Script panels_script(const PanelsFigure& figure);

}  // namespace eerie::pictures
