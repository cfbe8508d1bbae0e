#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/disk/drag.hpp"
#include "analysis/disk/encounter_speed.hpp"

namespace eerie::disk {

/// Speeds that contours are drawn of, m/s.
inline constexpr std::array contour_speeds = {0.02, 0.05, slow, fast, 1.0, 3.0, 10.0};

/// Where bodies meet with each of `contour_speeds`, over the distance from the star, by one law of
/// drag. The speeds are powers of alpha and of R, so that contours are exact.
struct Contours {
  DragLaw law = DragLaw::published;
  std::vector<double> r;               ///< m, rising
  std::vector<Drag> drag;              ///< at each r
  std::vector<std::vector<double>> y;  ///< [speed][r]: alpha, or radius of the stirrers, m

  const std::vector<double>& of(double speed) const;  ///< throws std::out_of_range
};

/// Distances from `low` to `high` (m, both included), evenly in their logarithm, with a pair at
/// each step of the formulas (snow line, edges of the published pieces).
std::vector<double> contour_distances(double low, double high);

/// alpha at which turbulence gives each speed. Throws InputError as drag_of.
Contours alpha_contours(DragLaw law, const Body& body, const std::vector<double>& r);
/// Radius of the stirrers (m) that gives each speed. Throws InputError as drag_of.
Contours stirrer_contours(DragLaw law, const Body& body, const Stirrers& stirrers,
                          const std::vector<double>& r);

/// One line per law and distance, units in the header. `quantity` starts the names of the contours'
/// columns, whose values are divided by `unit`.
std::string contours_csv(const std::vector<Contours>& laws, const std::string& quantity,
                         double unit);

}  // namespace eerie::disk
