#pragma once

#include <optional>
#include <string>
#include <vector>

#include "db/views/view.hpp"

namespace eerie::queries {

/// Which rows of a view: the conditions of `query` and of what else chooses among impacts.
struct Filter {
  std::optional<double> q, phi_d_deg;
  std::string v, theta;  ///< "LO:HI" or one number; empty: all
  std::string outcome_class, fidelity, sweep;
  bool eer = false;
  std::vector<std::string> where;  ///< "COLUMN=..."
};

/// The conditions and sweeps of a query of `view`. Throws InputError for what it does not have.
db::ViewQuery filtered(const db::Connection& connection, db::View view, const Filter& filter);

/// "b_over_a=0:0.3", "class=hit*,erosion", "period_h=none", "seed!=1". Throws InputError.
db::Condition parse_condition(const std::string& text);

/// "rank,-mass_kg" as sort keys. Columns that `known` lacks are an InputError, as in the others.
std::vector<db::SortKey> parse_sort(const std::string& text, db::View view,
                                    const std::vector<db::ViewColumn>& known);

/// "rank,mass_kg"; empty: none named.
std::vector<std::string> parse_columns(const std::string& text, db::View view,
                                       const std::vector<db::ViewColumn>& known);

}  // namespace eerie::queries
