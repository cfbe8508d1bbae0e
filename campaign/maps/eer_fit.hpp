#pragma once

#include <optional>
#include <vector>

#include "analysis/diagrams/phase_diagram.hpp"
#include "analysis/paper/eer_region.hpp"
#include "db/views/map_points.hpp"

namespace eerie::maps {

/// Whether both points belong to one map.
bool same_map(const db::MapPoint& a, const db::MapPoint& b);

/// The region of EERs in each of some maps, in the order of phase_diagrams(points); nothing where
/// runs are too few.
std::vector<std::optional<paper::EerRegion>> eer_regions(const std::vector<db::MapPoint>& points);

/// The borders of a region within a map, as curves.
diagrams::EerBorders borders_of(const paper::EerRegion& region, const diagrams::PhaseDiagram& map);

}  // namespace eerie::maps
