#pragma once

#include <span>
#include <vector>

#include "solver/io/snapshot.hpp"

namespace eerie::remnants {

/// The depth of each particle of the first snapshot below the surface of its own body, m, by
/// particle id. For an ellipsoid it is the depth of the same place in the sphere of its volume.
/// Particles above the surface have depth 0.
std::vector<double> initial_depths(const io::Snapshot& first);

/// The depths below the surface of its own body, m, from which the matter of a remnant comes.
struct OriginDepth {
  double mean = 0;
  double p10 = 0, p90 = 0;  ///< a tenth of the mass comes from above p10 and a tenth from below p90
};

/// The statistics of equal masses at these depths (m, in any order, at least one).
OriginDepth origin_depth(std::vector<double> depths);

}  // namespace eerie::remnants
