#pragma once

#include <filesystem>
#include <vector>

#include "analysis/drawing/script.hpp"
#include "analysis/light_curve/light_curve.hpp"

namespace eerie::light_curve {

struct LightCurveFigure {
  LightCurve curve;
  std::vector<AspectAmplitude> amplitudes;
  drawing::Quoted title = {};  ///< impact, remnant, time
  double period_s = 0;         ///< of the spin; 0: not known, the axis counts rotations
};

/// Draws two panels on the width of a page (18 cm): magnitudes over one rotation (h), and amplitude
/// over aspect with that of 1I/'Oumuamua. The extension names the format: .png, .svg or .pdf.
/// Throws InputError (another extension) and EnvironmentError (gnuplot or the disk fails).
void draw_light_curve(const std::filesystem::path& path, const LightCurveFigure& figure);

/// Draws the figure at `picture` and writes both tables beside it, STEM.csv and STEM-aspect.csv.
/// Returns the files. Throws as draw_light_curve() does.
std::vector<std::filesystem::path> write_light_curve(const std::filesystem::path& picture,
                                                     const LightCurveFigure& figure);

/// The gnuplot commands for the figure, without the terminal line.
drawing::Script light_curve_script(const LightCurveFigure& figure);

}  // namespace eerie::light_curve
