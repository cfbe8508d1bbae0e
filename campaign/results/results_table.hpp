#pragma once

#include <string>
#include <vector>

#include "campaign/text/table.hpp"
#include "db/views/query.hpp"

namespace eerie::results {

/// A table of results for people. Parameters that all rows share stand above it.
text::Table results_table(const std::vector<db::ResultRow>& rows);

/// The meanings of the marks in that table, one line each.
std::string legend_of(const std::vector<db::ResultRow>& rows);
/// The same, and in what settings differ where the rows have several.
std::string legend_of(const db::Connection& connection, const std::vector<db::ResultRow>& rows);

/// A sentence that warns of results that cannot be trusted; empty where all can.
std::string drift_warning(const db::Connection& connection, const std::vector<db::ResultRow>& rows);
/// The warning about the results of all sweeps of this name. A changed sweep file makes another
/// sweep of the same name.
std::string drift_warning(const db::Connection& connection, const std::string& sweep_name);

}  // namespace eerie::results
