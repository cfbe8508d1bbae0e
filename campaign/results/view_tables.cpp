#include "campaign/results/view_tables.hpp"

#include <algorithm>
#include <span>

#include "db/store/bind.hpp"
#include "db/store/column_meanings.hpp"

namespace eerie::results {
using db::Cell;
using db::ColumnKind;
using db::ViewRows;
using text::Column, text::Table, text::Value;

namespace {

Value value_of(const Cell& cell, ColumnKind kind) {
  if (const auto* whole = std::get_if<std::int64_t>(&cell))
    return kind == ColumnKind::flag ? Value(*whole != 0) : Value(*whole);
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return {};
}

constexpr const char* five_digits = "{:.5g}";

/// A column that people look at.
struct Looked {
  const char *column, *header;
  const char* pattern = five_digits;
  int dispensable = 0;
  bool above = false;
  const char* unit = "";  ///< where it stands above
};
constexpr Looked parameter(const char* column, const char* header, const char* unit = "") {
  return {column, header, five_digits, 0, true, unit};
}
constexpr Looked remnant_columns[] = {parameter("q", "q"),
                                      parameter("phi_d_deg", "phi_d", " deg"),
                                      {"v_imp_cm_per_s", "v cm/s"},
                                      {"theta_imp_deg", "theta deg"},
                                      parameter("scheme", "scheme"),
                                      parameter("settings", "settings"),
                                      parameter("seed", "seed"),
                                      {"rank", "rank"},
                                      {"particles", "particles", "{}", 3},
                                      {"mass_over_total", "m/M", "{:.3f}"},
                                      {"b_over_a", "b/a", "{:.3f}"},
                                      {"c_over_a", "c/a", "{:.3f}", 2},
                                      {"a_m", "a m", "{:.0f}", 3},
                                      {"spin_period_h", "period h", "{:.2f}", 2},
                                      {"eer", "EER"},
                                      {"bound_group", "group", "{}", 3},
                                      {"job", "job", "{}", 1}};
constexpr Looked map_columns[] = {parameter("q", "q"),
                                  parameter("phi_d_deg", "phi_d", " deg"),
                                  parameter("particles_per_target", "particles per target"),
                                  parameter("fidelity", "fidelity"),
                                  parameter("scheme", "scheme"),
                                  parameter("settings", "settings"),
                                  parameter("end_time_s", "end", " s"),
                                  {"v_imp_cm_per_s", "v cm/s"},
                                  {"theta_imp_deg", "theta deg"},
                                  {"v_over_v_esc", "v/v_esc", "{:.2f}", 3},
                                  {"jobs", "jobs", "{}", 2},
                                  {"done", "done", "{}", 1},
                                  {"failed", "failed", "{}", 2},
                                  {"b_over_a", "b/a", "{:.3f}"},
                                  {"b_over_a_min", "least", "{:.3f}", 1},
                                  {"b_over_a_max", "most", "{:.3f}", 1},
                                  {"m_lr_over_m_total", "M_lr/M", "{:.3f}", 1},
                                  {"period_h", "period h", "{:.2f}", 2},
                                  {"p_eer", "P(largest EER)", "{:.2f}"}};

Column for_people(const Looked& looked) {
  Column column = text::shown(looked.header, looked.pattern);
  column.mark = "*", column.unit_above = looked.unit;
  column.above = looked.above, column.dispensable = looked.dispensable;
  return column;
}

/// The database's number for settings says something to people only beside another one.
bool is_number_of_settings(const Looked& looked) {
  return std::string_view(looked.column) == "settings";
}

bool is_shared(const ViewRows& rows, std::size_t column) {
  return std::ranges::all_of(rows.rows, [&](const std::vector<Cell>& row) {
    return row[column] == rows.rows.front()[column];
  });
}

/// Types of the Table Schema. An integer that may be missing is a number to its readers.
const char* type_of(const ViewRows& rows, std::size_t column) {
  const bool gaps = std::ranges::any_of(rows.rows, [&](const std::vector<Cell>& row) {
    return std::holds_alternative<std::monostate>(row[column]);
  });
  switch (db::kind_of(rows.view, rows.columns[column])) {
    case ColumnKind::flag:
      return "boolean";
    case ColumnKind::word:
      return "string";
    case ColumnKind::integer:
      return gaps ? "number" : "integer";
    default:
      return "number";
  }
}

}  // namespace

Table plain_table(const ViewRows& rows) {
  Table table;
  std::vector<ColumnKind> kinds;
  for (const db::ViewColumn& one : rows.columns) {
    const db::ColumnMeaning* known = db::meaning_of(rows.view, one.name);
    Column& column = table.columns.emplace_back(text::both(one.name, one.name, five_digits));
    column.unit = db::unit_of(rows.view, one.name);
    column.meaning = known != nullptr ? known->meaning : "";
    kinds.push_back(db::kind_of(rows.view, one));
    if (kinds.back() == ColumnKind::integer) column.pattern = "{}";
  }
  for (const std::vector<Cell>& row : rows.rows) {
    std::vector<Value>& line = table.rows.emplace_back();
    for (std::size_t c = 0; c < row.size(); ++c) line.push_back(value_of(row[c], kinds[c]));
  }
  return table;
}

Table short_table(const ViewRows& rows) {
  Table table = plain_table(rows);
  for (Column& column : table.columns) column.for_people = false;
  const std::span<const Looked> wanted =
      rows.view == db::View::remnants ? std::span<const Looked>(remnant_columns)
      : rows.view == db::View::maps   ? std::span<const Looked>(map_columns)
                                      : std::span<const Looked>();
  for (const Looked& looked : wanted) {
    const auto column = rows.find(looked.column);
    if (!column || (is_number_of_settings(looked) && is_shared(rows, *column))) continue;
    table.columns.push_back(for_people(looked));
    for (std::vector<Value>& row : table.rows) row.push_back(Value(row[*column]));
  }
  return table;
}

nlohmann::json described(const ViewRows& rows) {
  const Table table = plain_table(rows);
  nlohmann::json fields = nlohmann::json::array();
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const Column& column = table.columns[k];
    fields.push_back({{"name", column.name},
                      {"type", type_of(rows, k)},
                      {"unit", column.unit},
                      {"description", column.meaning}});
  }
  return {{"name", db::name(db::view_names, rows.view)},
          {"schema", {{"fields", std::move(fields)}}},
          {"data", text::records(table)}};
}

}  // namespace eerie::results
