#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/disk/drag.hpp"
#include "analysis/disk/encounter_speed.hpp"

namespace eerie::disk {

/// The speeds of the contours, m/s.
inline constexpr std::array contour_speeds = {0.02, 0.05, slow, fast, 1.0, 3.0, 10.0};

/// The curves on which bodies meet with each of `contour_speeds`, over the distance from the star,
/// for one law of drag. The speeds are powers of alpha and of R, so the curves are exact.
struct Contours {
  DragLaw law = DragLaw::published;
  std::vector<double> r;               ///< m, rising
  std::vector<Drag> drag;              ///< drag at each r
  std::vector<std::vector<double>> y;  ///< [speed][r]: alpha, or the radius of the stirrers, m

  const std::vector<double>& of(double speed) const;  ///< throws std::out_of_range
};

/// Distances from `low` to `high` (m, both included), evenly spaced in their logarithm, with a pair
/// of distances at each step of the formulas (snow line, edges of the published pieces).
std::vector<double> contour_distances(double low, double high);

/// The alpha at which turbulence gives each speed. Throws InputError as drag_of() does.
Contours alpha_contours(DragLaw law, const Body& body, const std::vector<double>& r);
/// The radius of the stirrers (m) that gives each speed. Throws InputError as drag_of() does.
Contours stirrer_contours(DragLaw law, const Body& body, const Stirrers& stirrers,
                          const std::vector<double>& r);

/// A CSV table with one line per law and distance, and units in the header. The names of the
/// contour columns begin with `quantity`, and their values are divided by `unit`.
std::string contours_csv(const std::vector<Contours>& laws, const std::string& quantity,
                         double unit);

}  // namespace eerie::disk
