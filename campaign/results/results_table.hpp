#pragma once

#include <string>
#include <vector>

#include "campaign/text/table.hpp"
#include "db/views/query.hpp"

namespace eerie::results {

/// Results for people. Parameters that all rows share stand above.
text::Table results_table(const std::vector<db::ResultRow>& rows);

/// What the marks mean that occur in it, a line each.
std::string legend_of(const std::vector<db::ResultRow>& rows);

/// That results are not to be trusted, in one sentence; empty where all are.
std::string drift_warning(const std::vector<db::ResultRow>& rows);

}  // namespace eerie::results
