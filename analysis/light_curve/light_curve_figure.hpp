#pragma once

#include <filesystem>
#include <vector>

#include "analysis/drawing/script.hpp"
#include "analysis/light_curve/light_curve.hpp"

namespace eerie::light_curve {

struct LightCurveFigure {
  LightCurve curve;
  std::vector<AspectAmplitude> amplitudes;
};

/// Two panels on a journal's page (18 cm): magnitudes over the rotation, and amplitude over aspect
/// with that of 1I/'Oumuamua. The extension decides: .png, .svg, .pdf. Throws InputError (another
/// one) and EnvironmentError (gnuplot or the disk failed).
void draw_light_curve(const std::filesystem::path& path, const LightCurveFigure& figure);

/// gnuplot's commands for it, terminal apart.
drawing::Script light_curve_script(const LightCurveFigure& figure);

}  // namespace eerie::light_curve
