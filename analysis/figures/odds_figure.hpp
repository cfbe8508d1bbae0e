#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/drawing/script.hpp"

namespace eerie::figures {

/// The probability that a collision in a swarm leaves an EER, over the dispersion of velocities.
struct OddsCurve {
  struct Point {
    double dispersion_cm_per_s, p, error;  ///< error: one standard error of p
  };
  std::string name;  ///< of the map that it rests on
  std::vector<Point> points;
};

/// The gnuplot commands for all curves with bands of one standard error. The figure is as wide as a
/// column of a journal. Throws InputError where there is no curve.
drawing::Script odds_script(const std::vector<OddsCurve>& curves);

/// Draws the figure at `path` (.svg, .png or .pdf). Throws as run_gnuplot() does.
void draw_odds(const std::filesystem::path& path, const std::vector<OddsCurve>& curves);

}  // namespace eerie::figures
