#pragma once

#include <string>
#include <vector>

#include "analysis/figures/size_distribution.hpp"
#include "campaign/text/table.hpp"
#include "db/views/query.hpp"

namespace eerie::results {

/// The size distributions of the impacts that a query of results finds, one for each particle
/// number and settings.
std::vector<figures::SizeDistribution> size_distributions(const db::Connection& connection,
                                                          const db::ViewQuery& query);

/// A table of all steps of each distribution.
text::Table table_of_steps(const std::vector<figures::SizeDistribution>& all);

/// A table of remnants per impact at round masses, down to the finest limit. A value is null below
/// the limit of its column.
text::Table table_of_counts(const std::vector<figures::SizeDistribution>& all);

}  // namespace eerie::results
