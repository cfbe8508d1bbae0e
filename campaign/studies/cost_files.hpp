#pragma once

#include <filesystem>
#include <vector>

#include "campaign/studies/cost_cases.hpp"
#include "campaign/studies/cost_errors.hpp"
#include "campaign/text/table.hpp"

namespace eerie::studies {

/// A line per setting, for people.
text::Table table_of_points(const ChartStudy& study, const std::vector<ChartPoint>& points);

/// Draws the chart at `picture`, whose folder is there, with its tables and the picture of the
/// cases beside it. Returns the files.
std::vector<std::filesystem::path> write_chart(const ChartStudy& study,
                                               const std::vector<ChartResult>& results,
                                               const std::vector<ChartPoint>& points,
                                               const std::filesystem::path& picture);

}  // namespace eerie::studies
