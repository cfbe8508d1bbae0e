#include "campaign/cli/output/view_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "campaign/cli/output/text_table.hpp"
#include "campaign/text/csv.hpp"
#include "db/store/bind.hpp"
#include "db/views/column_meanings.hpp"

namespace eerie::cli {
using db::Cell;
using db::ColumnKind;
using db::ViewRows;
using nlohmann::json;

namespace {

json value_of(const Cell& cell, ColumnKind kind) {
  if (const auto* whole = std::get_if<std::int64_t>(&cell))
    return kind == ColumnKind::flag ? json(*whole != 0) : json(*whole);
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return {};
}

std::string csv_text(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return text::csv_field(*text);
  const json value = value_of(cell, ColumnKind::number);
  return value.is_null() ? "" : value.dump();
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

/// Five digits, or so many decimals where `decimals` says so.
std::string short_text(const Cell& cell, int decimals = -1) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *whole);
  const auto* number = std::get_if<double>(&cell);
  if (number == nullptr) return "-";
  return decimals < 0 ? fmt::format("{:.5g}", *number) : fmt::format("{:.{}f}", *number, decimals);
}

/// A column of a short table.
struct Shown {
  const char* column;
  const char* header;
  int decimals = -1;       ///< -1: five digits
  bool parameter = false;  ///< stands above the table where all rows share it
  const char* unit = "";   ///< of a parameter
};
constexpr Shown remnant_columns[] = {{"q", "q", -1, true},
                                     {"phi_d_deg", "phi_d", -1, true, " deg"},
                                     {"v_imp_cm_per_s", "v cm/s"},
                                     {"theta_imp_deg", "theta deg"},
                                     {"seed", "seed", -1, true},
                                     {"rank", "rank"},
                                     {"particles", "particles"},
                                     {"mass_over_total", "m/M", 3},
                                     {"b_over_a", "b/a", 3},
                                     {"c_over_a", "c/a", 3},
                                     {"a_m", "a m", 0},
                                     {"spin_period_h", "period h", 2},
                                     {"eer", "EER"},
                                     {"bound_group", "group"},
                                     {"job", "job"}};
constexpr Shown map_columns[] = {{"q", "q", -1, true},
                                 {"phi_d_deg", "phi_d", -1, true, " deg"},
                                 {"particles_per_target", "particles per target", -1, true},
                                 {"fidelity", "fidelity", -1, true},
                                 {"end_time_s", "end", -1, true, " s"},
                                 {"v_imp_cm_per_s", "v cm/s"},
                                 {"theta_imp_deg", "theta deg"},
                                 {"v_over_v_esc", "v/v_esc", 2},
                                 {"jobs", "jobs"},
                                 {"done", "done"},
                                 {"failed", "failed"},
                                 {"b_over_a", "b/a", 3},
                                 {"b_over_a_min", "least", 3},
                                 {"b_over_a_max", "most", 3},
                                 {"m_lr_over_m_total", "M_lr/M", 3},
                                 {"period_h", "period h", 2},
                                 {"p_eer", "p(EER)", 2}};

bool shared(const ViewRows& rows, std::size_t column) {
  return std::ranges::all_of(rows.rows, [&](const std::vector<Cell>& row) {
    return row[column] == rows.rows.front()[column];
  });
}

}  // namespace

json records(const ViewRows& rows) {
  std::vector<ColumnKind> kinds;
  for (const db::ViewColumn& column : rows.columns) kinds.push_back(db::kind_of(rows.view, column));
  json list = json::array();
  for (const std::vector<Cell>& row : rows.rows) {
    json record = json::object();
    for (std::size_t k = 0; k < row.size(); ++k)
      record[rows.columns[k].name] = value_of(row[k], kinds[k]);
    list.push_back(std::move(record));
  }
  return list;
}

json described(const ViewRows& rows) {
  json fields = json::array();
  for (std::size_t k = 0; k < rows.columns.size(); ++k) {
    const std::string& name = rows.columns[k].name;
    const db::ColumnMeaning* known = db::meaning_of(rows.view, name);
    fields.push_back({{"name", name},
                      {"type", type_of(rows, k)},
                      {"unit", db::unit_of(rows.view, name)},
                      {"description", known != nullptr ? known->meaning : ""}});
  }
  return {{"name", db::name(db::view_names, rows.view)},
          {"schema", {{"fields", std::move(fields)}}},
          {"data", records(rows)}};
}

std::string csv(const ViewRows& rows) {
  std::string text;
  for (const db::ViewColumn& column : rows.columns)
    text += (text.empty() ? "" : ",") + text::csv_field(column.name);
  text += "\n";
  for (const std::vector<Cell>& row : rows.rows) {
    for (std::size_t k = 0; k < row.size(); ++k) text += (k == 0 ? "" : ",") + csv_text(row[k]);
    text += "\n";
  }
  return text;
}

std::string plain_table(const ViewRows& rows) {
  if (rows.rows.empty()) return "";
  std::vector<std::vector<std::string>> table(1);
  for (const db::ViewColumn& column : rows.columns) table[0].push_back(column.name);
  for (const std::vector<Cell>& row : rows.rows) {
    std::vector<std::string>& line = table.emplace_back();
    for (const Cell& cell : row) line.push_back(short_text(cell));
  }
  return text_table(table);
}

std::string short_table(const ViewRows& rows) {
  if (rows.rows.empty()) return "";
  const std::span<const Shown> wanted = rows.view == db::View::remnants
                                            ? std::span<const Shown>(remnant_columns)
                                            : std::span<const Shown>(map_columns);
  std::string above;
  std::vector<std::vector<std::string>> table(rows.rows.size() + 1);
  for (const Shown& shown : wanted) {
    const auto column = rows.find(shown.column);
    if (!column) continue;
    if (shown.parameter && shared(rows, *column)) {
      const Cell& cell = rows.rows.front()[*column];
      if (!std::holds_alternative<std::monostate>(cell))
        above += fmt::format("{}{} {}{}", above.empty() ? "" : ", ", shown.header, short_text(cell),
                             shown.unit);
      continue;
    }
    table[0].push_back(std::string(shown.header) + shown.unit);
    const bool flag = db::kind_of(rows.view, rows.columns[*column]) == ColumnKind::flag;
    for (std::size_t k = 0; k < rows.rows.size(); ++k) {
      const Cell& cell = rows.rows[k][*column];
      table[k + 1].push_back(flag ? (cell == Cell(std::int64_t{1}) ? "*" : "")
                                  : short_text(cell, shown.decimals));
    }
  }
  return (above.empty() ? "" : above + "\n\n") + text_table(table);
}

}  // namespace eerie::cli
