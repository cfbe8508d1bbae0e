#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/drawing/script.hpp"

namespace eerie::figures {

/// The masses of the remnants of impacts with equal settings, in units of the mass of both bodies.
struct SizeDistribution {
  std::string name;  ///< of the settings
  std::int64_t particles_per_target = 0;
  std::size_t impacts = 0;
  /// The mass of the smallest remnant that the resolution allows; nothing is known below it. Where
  /// impacts differ in it, this is the largest.
  double limit = 0;
  std::vector<double> masses;  ///< of all impacts, the largest first

  /// The number of remnants per impact of at least this mass.
  double count_from(double mass) const;
};

/// A step of the cumulative distribution: the number of remnants per impact from this mass up.
struct SizeStep {
  double mass = 0, count = 0;
};
/// The steps from the most massive remnant down. Equal masses make one step.
std::vector<SizeStep> steps(const SizeDistribution& distribution);

/// The gnuplot commands for N(>= m) of each distribution over the logarithm of m, with a line at
/// each limit. The figure is as wide as a column of a journal. Throws InputError where there is no
/// remnant.
drawing::Script sizes_script(const std::vector<SizeDistribution>& distributions);

/// Draws the figure at `path` (.svg, .png or .pdf). Throws as run_gnuplot() does.
void draw_sizes(const std::filesystem::path& path,
                const std::vector<SizeDistribution>& distributions);

}  // namespace eerie::figures
