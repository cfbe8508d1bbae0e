#include "db/views/view.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <algorithm>

#include "db/store/bind.hpp"
#include "db/store/error.hpp"

namespace eerie::db {
namespace {

using Columns = std::vector<ViewColumn>;

// Of the connection, so that it needs no newer schema of the file, and a reader can make it.
constexpr const char* make_all_jobs = R"sql(
CREATE TEMP VIEW IF NOT EXISTS all_jobs AS
SELECT j.id AS job, j.hash AS hash, j.state, j.wanted, j.priority, j.crashes,
       j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.v_over_v_esc,
       j.particles_per_target, j.seed, j.end_time_s, j.fidelity, j.settings,
       r.class, r.b_over_a, r.c_over_a, r.m_lr_over_m_total, r.m_slr_over_m_total, r.period_h,
       r.eer, r.n_eer, r.n_remnants, r.settled, r.unsettled_reason,
       r.ended_at_s, r.end_reason, r.dL_over_L, r.steps, r.particle_steps, r.wall_s, r.threads,
       r.solver_version, r.host, r.finished,
       CASE WHEN r.job_id IS NOT NULL THEN coalesce(r.solver_version <> now.value, 0) END AS stale,
       s.scheme, f.job_folder
FROM main.jobs j LEFT JOIN main.job_results r ON r.job_id = j.id
     JOIN main.job_folders f ON f.job_id = j.id
     LEFT JOIN main.job_settings s ON s.id = j.settings
     LEFT JOIN main.settings now ON now.key = 'solver_version'
)sql";

Columns columns(SQLite::Database& sql, View view) {
  if (view == View::all_jobs) sql.exec(make_all_jobs);
  Columns list;
  SQLite::Statement select(sql, "SELECT name, type FROM pragma_table_info(?)");
  bind_all(select, name(view_names, view));
  while (select.executeStep())
    list.push_back({select.getColumn(0).getString(), select.getColumn(1).getString()});
  return list;
}

bool has(const Columns& list, const std::string& column) {
  return std::ranges::find(list, column, &ViewColumn::name) != list.end();
}

/// The name as SQL, of a column that is there: nothing else ever becomes part of a statement.
std::string quoted(const Columns& list, const std::string& column) {
  if (!has(list, column)) throw Error("the view has no column \"" + column + "\"");
  return '"' + column + '"';
}

/// What stands in a condition as ?: bound in the order of the text.
using Parameters = std::vector<std::variant<double, std::string>>;

void bind_parameters(SQLite::Statement& select, const Parameters& parameters) {
  int index = 0;
  for (const auto& parameter : parameters)
    std::visit([&](const auto& value) { bind_value(select, ++index, value); }, parameter);
}

std::string text_of(const Condition& c, const std::string& column, Parameters& parameters) {
  std::vector<std::string> all;
  if (c.empty) all.push_back(column + " IS NULL");
  if (c.lo) all.push_back(column + " >= ?"), parameters.emplace_back(*c.lo);
  if (c.hi) all.push_back(column + " <= ?"), parameters.emplace_back(*c.hi);
  std::vector<std::string> any;
  for (const std::string& word : c.words)
    any.push_back(column + " GLOB ?"), parameters.emplace_back(word);
  if (!any.empty()) all.push_back(fmt::format("({})", fmt::join(any, " OR ")));
  if (all.empty()) throw Error("a condition on " + column + " says nothing");
  const std::string text = fmt::format("coalesce({}, 0)", fmt::join(all, " AND "));
  return c.negated ? "NOT " + text : text;
}

std::string conditions(SQLite::Database& sql, const ViewQuery& query, const Columns& known,
                       Parameters& parameters) {
  std::string text;
  for (const Condition& c : query.conditions) {
    if (has(known, c.column) || !has(known, "job")) {
      text += " AND " + text_of(c, quoted(known, c.column), parameters);
      continue;
    }
    const std::string column = quoted(columns(sql, View::results), c.column);
    text += " AND job IN (SELECT job FROM results WHERE " + text_of(c, column, parameters) + ")";
  }
  if (!query.sweeps.empty()) {
    if (!has(known, "job")) throw Error("the view has no jobs to belong to a sweep");
    text += fmt::format(" AND job IN (SELECT job_id FROM sweep_jobs WHERE sweep_id IN ({}))",
                        fmt::join(query.sweeps, ", "));
  }
  return text;
}

/// The order of rows that nobody asked to sort otherwise: by the point.
std::string order(const ViewQuery& query, const Columns& known) {
  std::vector<std::string> keys;
  for (const SortKey& key : query.sort)
    keys.push_back(quoted(known, key.column) + (key.descending ? " DESC" : "") + " NULLS LAST");
  for (const char* column : {"q", "phi_d_deg", "v_imp_cm_per_s", "theta_imp_deg",
                             "particles_per_target", "seed", "job", "rank"})
    if (has(known, column)) keys.push_back(quoted(known, column));
  return fmt::format(" ORDER BY {}", fmt::join(keys, ", "));
}

Cell cell(const SQLite::Column& column) {
  switch (column.getType()) {
    case SQLITE_NULL:
      return {};
    case SQLITE_INTEGER:
      return column.getInt64();
    case SQLITE_FLOAT:
      return column.getDouble();
    default:
      return column.getString();
  }
}

}  // namespace

std::vector<ViewColumn> columns(const Connection& connection, View view) {
  Columns list;
  connection.read([&](SQLite::Database& sql) { list = columns(sql, view); });
  return list;
}

bool has_jobs(const Connection& connection, View view) {
  return has(columns(connection, view), "job");
}

bool is_condition_column(const Connection& connection, View view, const std::string& column) {
  const Columns known = columns(connection, view);
  return has(known, column) ||
         (has(known, "job") && has(columns(connection, View::results), column));
}

void each_row(const Connection& connection, const ViewQuery& query,
              const std::function<void(SQLite::Statement&)>& body) {
  connection.read([&](SQLite::Database& sql) {
    const Columns known = columns(sql, query.view);
    std::vector<std::string> selected;
    for (const std::string& column : query.columns) selected.push_back(quoted(known, column));
    Parameters parameters;
    std::string text =
        fmt::format("SELECT {} FROM {} WHERE 1",
                    selected.empty() ? "*" : fmt::format("{}", fmt::join(selected, ", ")),
                    name(view_names, query.view));
    text += conditions(sql, query, known, parameters) + order(query, known);
    if (query.limit) text += fmt::format(" LIMIT {} OFFSET {}", *query.limit, query.offset);
    SQLite::Statement select(sql, text);
    bind_parameters(select, parameters);
    while (select.executeStep()) body(select);
  });
}

std::optional<std::size_t> ViewRows::find(std::string_view column) const {
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k].name == column) return k;
  return std::nullopt;
}

ViewRows rows(const Connection& connection, const ViewQuery& query) {
  ViewRows found;
  found.view = query.view;
  const Columns known = columns(connection, query.view);
  if (query.columns.empty()) found.columns = known;
  for (const std::string& column : query.columns)
    for (const ViewColumn& one : known)
      if (one.name == column) found.columns.push_back(one);
  each_row(connection, query, [&](SQLite::Statement& row) {
    std::vector<Cell>& cells = found.rows.emplace_back();
    for (int k = 0; k < row.getColumnCount(); ++k) cells.push_back(cell(row.getColumn(k)));
  });
  return found;
}

ViewSummary summary(const Connection& connection, const ViewQuery& query,
                    const std::vector<std::string>& of) {
  ViewSummary found;
  connection.read([&](SQLite::Database& sql) {
    const Columns known = columns(sql, query.view);
    std::string text = "SELECT count(*)";
    for (const std::string& column : of)
      // Some values and some missing ones are different, too.
      text += fmt::format(", min({0}) <> max({0}) OR count({0}) NOT IN (0, count(*))",
                          quoted(known, column));
    Parameters parameters;
    text += fmt::format(" FROM {} WHERE 1", name(view_names, query.view));
    text += conditions(sql, query, known, parameters);
    SQLite::Statement select(sql, text);
    bind_parameters(select, parameters);
    select.executeStep();
    found.rows = select.getColumn(0).getInt64();
    for (std::size_t k = 0; k < of.size(); ++k)
      if (select.getColumn(static_cast<int>(k) + 1).getInt() != 0) found.differing.push_back(of[k]);
  });
  return found;
}

}  // namespace eerie::db
