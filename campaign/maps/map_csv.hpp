#pragma once

#include <string>
#include <vector>

#include "db/views/map_points.hpp"

namespace eerie::maps {

/// The numbers of maps, one line per point and settings, units in the header. Means and sample
/// standard deviations over seeds; a field is empty where there is no such number.
std::string map_csv(const std::vector<db::MapPoint>& points);

}  // namespace eerie::maps
