#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "db/store/connection.hpp"

namespace SQLite {
class Statement;
}

namespace eerie::db {

/// The views for users (docs/reference/database.md). `all_jobs` is made by each connection for
/// itself: all jobs, with their results where they have one.
enum class View { results, remnants, maps, all_jobs };
inline constexpr std::array<std::string_view, 4> view_names = {"results", "remnants", "maps",
                                                               "all_jobs"};

struct ViewColumn {
  std::string name;
  std::string declared;  ///< SQL type of the table's column behind it; empty: an expression
};

/// The columns that the view has in this database, in its order.
std::vector<ViewColumn> columns(const Connection& connection, View view);

/// What a column must hold; empty values never do, unless asked for.
struct Condition {
  std::string column;
  std::optional<double> lo = {}, hi = {};  ///< both inclusive
  std::vector<std::string> words = {};     ///< one of these; * and ? stand for other letters
  bool empty = false;                      ///< no value
  bool negated = false;                    ///< the contrary
};

struct SortKey {
  std::string column;
  bool descending = false;
};

struct ViewQuery {
  View view = View::results;
  std::vector<std::string> columns = {};   ///< empty: all, in the order of the view
  std::vector<Condition> conditions = {};  ///< all must hold; see is_condition_column()
  std::vector<std::int64_t> sweeps = {};   ///< of one of these sweeps; empty: of any or none
  std::vector<SortKey> sort = {};          ///< before the view's own order; empty values last
  std::optional<std::int64_t> limit = {};
  std::int64_t offset = 0;  ///< rows left out at the start; with a limit
};

/// A condition may name a column of the view, or of `results` where the view has jobs.
bool is_condition_column(const Connection& connection, View view, const std::string& column);

/// Whether rows of the view belong to one job each.
bool has_jobs(const Connection& connection, View view);

/// Runs `body` on each row. Names that the view does not have throw Error: callers who take them
/// from people ask first.
void each_row(const Connection& connection, const ViewQuery& query,
              const std::function<void(SQLite::Statement&)>& body);

/// monostate: no value.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string>;

struct ViewRows {
  View view = View::results;
  std::vector<ViewColumn> columns;
  std::vector<std::vector<Cell>> rows;

  /// Where the column stands; nothing where it was not asked for.
  std::optional<std::size_t> find(std::string_view column) const;
};
ViewRows rows(const Connection& connection, const ViewQuery& query);

/// All rows that a query finds, whatever its limit.
struct ViewSummary {
  std::int64_t rows = 0;
  std::vector<std::string> differing;  ///< of the columns asked for, those of several values
};
ViewSummary summary(const Connection& connection, const ViewQuery& query,
                    const std::vector<std::string>& columns);

}  // namespace eerie::db
