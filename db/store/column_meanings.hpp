#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace eerie::db {

/// The views for users (docs/reference/database.md). Each connection makes `all_jobs` for itself:
/// it has all jobs, with the result of those that have one.
enum class View { results, remnants, maps, all_jobs };
inline constexpr std::array<std::string_view, 4> view_names = {"results", "remnants", "maps",
                                                               "all_jobs"};

struct ViewColumn {
  std::string name;
  std::string declared;  ///< SQL type of the column of a table behind it; empty for an expression
};

enum class ColumnKind { number, integer, flag, word };

/// The meaning of a column of a view, for headers of exported files and the table `units`.
struct ColumnMeaning {
  std::string_view name;
  std::string_view unit;  ///< "" where it has none
  ColumnKind kind = ColumnKind::number;
  std::string_view meaning;
  std::optional<View> only = {};  ///< set where another view uses this name for another quantity
};

/// The one table of columns. A new column of a view is one line here.
std::span<const ColumnMeaning> column_meanings();

/// The entry of a column; nullptr for a column of a later schema.
const ColumnMeaning* meaning_of(View view, std::string_view column);

/// The unit at the end of a name, such as "cm/s" for v_imp_cm_per_s; "" where there is none.
std::string_view unit_in_name(std::string_view column);

/// The unit and kind of a column. For a column that the table lacks they follow from its name and
/// its SQL type.
std::string_view unit_of(View view, std::string_view column);
ColumnKind kind_of(View view, const ViewColumn& column);

}  // namespace eerie::db
