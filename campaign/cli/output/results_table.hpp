#pragma once

#include <string>
#include <vector>

#include "db/views/query.hpp"

namespace eerie::cli {

/// The table for people, with a legend of its marks. Parameters that all rows share stand above.
std::string results_table(const std::vector<db::ResultRow>& rows);

}  // namespace eerie::cli
