#pragma once

#include "campaign/text/table.hpp"
#include "db/views/view.hpp"

namespace eerie::results {

/// A table of every column under its own name, for programs and for people.
text::Table plain_table(const db::ViewRows& rows);

/// A table of every column for programs. For people it has selected columns of remnants and maps
/// under short names; results_table() shows results.
text::Table short_table(const db::ViewRows& rows);

/// A Tabular Data Resource, which pandas reads with orient="table": {"name", "schema": {"fields":
/// [{"name", "type", "unit", "description"}]}, "data": records}.
nlohmann::json described(const db::ViewRows& rows);

}  // namespace eerie::results
