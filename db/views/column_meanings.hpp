#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "db/views/view.hpp"

namespace eerie::db {

enum class ColumnKind { number, integer, flag, word };

/// What a column of a view says, for headers of exported files.
struct ColumnMeaning {
  std::string_view name;
  std::string_view unit;  ///< "": none
  ColumnKind kind = ColumnKind::number;
  std::string_view meaning;
  std::optional<View> only = {};  ///< where another view has a column of this name for other things
};

/// The one table of columns: a new column of a view is a line here.
std::span<const ColumnMeaning> column_meanings();

/// nullptr: a column of a later schema that the table lacks.
const ColumnMeaning* meaning_of(View view, std::string_view column);

/// The unit that a name ends in: "cm/s" of v_imp_cm_per_s; "" where it ends in none.
std::string_view unit_in_name(std::string_view column);

/// Unit and kind, also of a column that the table lacks: by its name and SQL type.
std::string_view unit_of(View view, std::string_view column);
ColumnKind kind_of(View view, const ViewColumn& column);

}  // namespace eerie::db
