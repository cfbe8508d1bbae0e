#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/drawing/script.hpp"

namespace eerie::figures {

/// Masses of the remnants of impacts that were run alike, over the mass of both bodies.
struct SizeDistribution {
  std::string name;  ///< of the settings
  std::int64_t particles_per_target = 0;
  std::size_t impacts = 0;
  /// The mass of the fewest particles that make a remnant: below it nothing is known. Of impacts
  /// that differ in it, the largest.
  double limit = 0;
  std::vector<double> masses;  ///< of all impacts, falling

  /// Remnants per impact of at least this mass.
  double count_from(double mass) const;
};

/// A step of the cumulative distribution: so many per impact from this mass up.
struct SizeStep {
  double mass = 0, count = 0;
};
/// From the most massive remnant down; equal masses are one step.
std::vector<SizeStep> steps(const SizeDistribution& distribution);

/// gnuplot's commands for N(>= m) of each over the logarithm of m, as wide as a column of a
/// journal; a line at each limit. Throws InputError where no remnant is there.
drawing::Script sizes_script(const std::vector<SizeDistribution>& distributions);

/// Draws it at `path` (.svg, .png, .pdf). Throws as run_gnuplot() does.
void draw_sizes(const std::filesystem::path& path,
                const std::vector<SizeDistribution>& distributions);

}  // namespace eerie::figures
