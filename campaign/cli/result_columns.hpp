#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "db/query.hpp"

namespace eerie::cli {

/// Every result as {"job": ..., "q": ..., ...}: the columns of the view `results`.
nlohmann::json results_json(const std::vector<db::ResultRow>& rows);

/// The same as CSV; the units are in the column names. Empty fields are unknown values.
std::string results_csv(const std::vector<db::ResultRow>& rows);

/// The table for people, with a legend of its marks. Parameters that all rows share stand above.
std::string results_table(const std::vector<db::ResultRow>& rows);

}  // namespace eerie::cli
