#pragma once

#include <optional>
#include <string>
#include <vector>

#include "db/views/view.hpp"

namespace eerie::queries {

/// The conditions that choose rows of a view, for `query` and other commands that choose among
/// impacts.
struct Filter {
  std::optional<double> q, phi_d_deg;
  std::string v, theta;  ///< "LO:HI" or one number; empty: all
  std::string outcome_class, fidelity, sweep;
  bool eer = false;
  std::vector<std::string> where;  ///< "COLUMN=..."
};

/// A query of `view` with these conditions and sweeps. Throws InputError for columns and sweeps
/// that do not exist.
db::ViewQuery filtered(const db::Connection& connection, db::View view, const Filter& filter);

/// A condition from its text: "b_over_a=0:0.3", "class=hit*,erosion", "period_h=none", "seed!=1".
/// Throws InputError.
db::Condition parse_condition(const std::string& text);

/// Sort keys from "rank,-mass_kg". Throws InputError for columns that are not in `known`.
std::vector<db::SortKey> parse_sort(const std::string& text, db::View view,
                                    const std::vector<db::ViewColumn>& known);

/// Names of columns from "rank,mass_kg"; none for an empty text. Throws InputError for columns that
/// are not in `known`.
std::vector<std::string> parse_columns(const std::string& text, db::View view,
                                       const std::vector<db::ViewColumn>& known);

}  // namespace eerie::queries
