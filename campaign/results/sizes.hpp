#pragma once

#include <string>
#include <vector>

#include "analysis/figures/size_distribution.hpp"
#include "campaign/text/table.hpp"
#include "db/views/query.hpp"

namespace eerie::results {

/// Of the impacts that a query of results leaves, those of one particle number and settings
/// together.
std::vector<figures::SizeDistribution> size_distributions(const db::Connection& connection,
                                                          const db::ViewQuery& query);

/// Every step of each.
text::Table table_of_steps(const std::vector<figures::SizeDistribution>& all);

/// Remnants per impact at round masses down to the finest limit; null below that of a column.
text::Table table_of_counts(const std::vector<figures::SizeDistribution>& all);

}  // namespace eerie::results
