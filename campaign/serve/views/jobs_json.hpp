#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "campaign/serve/reply.hpp"
#include "db/store/connection.hpp"

namespace eerie::serve {

/// A page of the table of all jobs. The parameters are the options of `eerie query` (q, phi_d, v,
/// theta, class, fidelity, sweep, eer, where, sort), state, limit (1 to 1000) and offset. Returns
/// {"total", "differing", "columns": [{"name", "unit", "meaning"}], "rows": [[...]]}. Columns with
/// one value for all rows are in "shared" instead. Throws InputError.
nlohmann::json jobs_json(const db::Connection& connection, const Parameters& parameters);

/// All rows that the filter finds, as CSV with the columns of the page.
std::string jobs_csv(const db::Connection& connection, const Parameters& parameters);

/// The jobs of one cell of a map (q, phi_d, v, theta, settings): {"jobs": [{column: value}]}.
nlohmann::json cell_jobs_json(const db::Connection& connection, const Parameters& parameters);

}  // namespace eerie::serve
