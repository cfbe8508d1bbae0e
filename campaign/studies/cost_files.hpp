#pragma once

#include <filesystem>
#include <vector>

#include "campaign/studies/cost_cases.hpp"
#include "campaign/studies/cost_errors.hpp"
#include "campaign/text/table.hpp"

namespace eerie::studies {

/// A table with one row per setting, for people.
text::Table table_of_points(const CostStudy& study, const std::vector<CostPoint>& points);

/// Draws the chart at `picture`, whose folder exists. It writes the tables and the picture of the
/// cases beside it. Returns the files.
std::vector<std::filesystem::path> write_cost_study(const CostStudy& study,
                                                    const std::vector<CostResult>& results,
                                                    const std::vector<CostPoint>& points,
                                                    const std::filesystem::path& picture);

}  // namespace eerie::studies
