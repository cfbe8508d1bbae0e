#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "db/views/view.hpp"

namespace eerie::cli {

/// One {"column": value, ...} per row; flags are true or false, unknown values null.
nlohmann::json records(const db::ViewRows& rows);

/// {"name", "schema": {"fields": [{"name", "type", "unit", "description"}]}, "data": records}: a
/// Tabular Data Resource, as pandas reads with orient="table".
nlohmann::json described(const db::ViewRows& rows);

/// RFC 4180; the units are in the names of the header. Unknown values are empty fields, flags 0
/// or 1.
std::string csv(const db::ViewRows& rows);

/// Every column as it is named, for people.
std::string plain_table(const db::ViewRows& rows);

/// The columns that people look at, under short names; what all rows share stands above. Of
/// remnants and maps: results have results_table().
std::string short_table(const db::ViewRows& rows);

}  // namespace eerie::cli
