#pragma once

#include <span>
#include <vector>

#include "solver/io/snapshot.hpp"

namespace eerie::remnants {

/// How deep below the surface of its own body (target or impactor, taken as spheres) each particle
/// of the first snapshot lies, m; by particle id. Particles of a jagged surface have depth 0.
std::vector<double> initial_depths(const io::Snapshot& first);

/// Where the matter of a remnant comes from: depths below the surface of its own body, m.
struct OriginDepth {
  double mean = 0;
  double p10 = 0, p90 = 0;  ///< a tenth of the mass comes from above p10, a tenth from below p90
};

/// Of equal masses at these depths (m, any order). At least one.
OriginDepth origin_depth(std::vector<double> depths);

}  // namespace eerie::remnants
