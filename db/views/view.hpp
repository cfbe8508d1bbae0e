#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "db/store/column_meanings.hpp"
#include "db/store/connection.hpp"

namespace SQLite {
class Statement;
}

namespace eerie::db {

/// The columns of the view in this database, in its order.
std::vector<ViewColumn> columns(const Connection& connection, View view);

/// A condition on a column. Empty values satisfy it only with `empty`.
struct Condition {
  std::string column;
  std::optional<double> lo = {}, hi = {};  ///< both ends are included
  /// One of these must match; * and ? stand for other letters.
  std::vector<std::string> words = {};
  bool empty = false;    ///< whether the column must have no value
  bool negated = false;  ///< whether the condition is negated
};

struct SortKey {
  std::string column;
  bool descending = false;
};

struct ViewQuery {
  View view = View::results;
  std::vector<std::string> columns = {};   ///< empty: all columns, in the order of the view
  std::vector<Condition> conditions = {};  ///< all must hold; see is_condition_column()
  /// The job must belong to one of these sweeps; empty: no condition.
  std::vector<std::int64_t> sweeps = {};
  std::vector<SortKey> sort = {};  ///< goes before the view's own order; empty values come last
  std::optional<std::int64_t> limit = {};
  std::int64_t offset = 0;  ///< rows to skip at the start; needs a limit
};

/// A condition may name a column of the view, or of `results` where the view has jobs.
bool is_condition_column(const Connection& connection, View view, const std::string& column);

/// Whether each row of the view belongs to one job.
bool has_jobs(const Connection& connection, View view);

/// Runs `body` on each row. Throws Error for a name that the view does not have; callers must check
/// names from users first.
void each_row(const Connection& connection, const ViewQuery& query,
              const std::function<void(SQLite::Statement&)>& body);

/// A value of a row. std::monostate means that there is none.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string>;

struct ViewRows {
  View view = View::results;
  std::vector<ViewColumn> columns;
  std::vector<std::vector<Cell>> rows;

  /// The index of a column; nothing where the query does not include it.
  std::optional<std::size_t> find(std::string_view column) const;
};
ViewRows rows(const Connection& connection, const ViewQuery& query);

/// A summary of all rows that a query finds, without its limit.
struct ViewSummary {
  std::int64_t rows = 0;
  std::vector<std::string> differing;  ///< requested columns that have several values
};
ViewSummary summary(const Connection& connection, const ViewQuery& query,
                    const std::vector<std::string>& columns);

}  // namespace eerie::db
