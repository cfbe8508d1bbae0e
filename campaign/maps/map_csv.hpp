#pragma once

#include <string>
#include <vector>

#include "db/views/map_points.hpp"

namespace eerie::maps {

/// The numbers of maps as CSV, with one line per point and settings, and units in the header. They
/// are means and sample standard deviations over seeds. A field is empty where there is no such
/// number.
std::string map_csv(const std::vector<db::MapPoint>& points);

}  // namespace eerie::maps
