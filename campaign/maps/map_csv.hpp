#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/paper/eer_region.hpp"
#include "db/views/map_points.hpp"

namespace eerie::maps {

/// The numbers of maps as CSV, with one line per point and settings, and units in the header. They
/// are means and sample standard deviations over seeds. A field is empty where there is no such
/// number. With `regions`, one for each map of the points in turn, three more columns have the
/// fitted P(EER) and its interval.
std::string map_csv(const std::vector<db::MapPoint>& points,
                    const std::vector<std::optional<paper::EerRegion>>& regions = {});

}  // namespace eerie::maps
