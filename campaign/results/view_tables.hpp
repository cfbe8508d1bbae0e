#pragma once

#include "campaign/text/table.hpp"
#include "db/views/view.hpp"

namespace eerie::results {

/// Every column, for programs and for people, as it is named.
text::Table plain_table(const db::ViewRows& rows);

/// Every column for programs; for people those of remnants and maps that they look at, under short
/// names: results have results_table().
text::Table short_table(const db::ViewRows& rows);

/// {"name", "schema": {"fields": [{"name", "type", "unit", "description"}]}, "data": records}: a
/// Tabular Data Resource, as pandas reads with orient="table".
nlohmann::json described(const db::ViewRows& rows);

}  // namespace eerie::results
