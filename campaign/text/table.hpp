#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace eerie::text {

/// A value of a table: null, a flag, a number or a word.
using Value = nlohmann::json;

template <class T>
Value or_null(const std::optional<T>& value) {
  return value ? Value(*value) : Value();
}

/// A column. Programs see it under its name, people under its header.
struct Column {
  std::string name = {};  ///< key in JSON and CSV, with its unit; empty: only people see the column
  std::string header = {};              ///< for people, with its unit
  std::string pattern = "{}";           ///< format of its numbers, for people
  std::string unit = {}, meaning = {};  ///< for programs
  std::string mark = "yes";             ///< shown to people for a flag that is set
  std::string unit_above = {};          ///< unit shown where the value stands above the table
  bool for_people = true;
  bool above = false;   ///< shows the value above the table where all rows share it
  int dispensable = 0;  ///< columns with a higher number are left out first on a narrow terminal
};

/// A column for programs alone.
inline Column data(std::string name) { return {.name = std::move(name), .for_people = false}; }
/// A column for people alone.
inline Column shown(std::string header, std::string pattern = "{}") {
  return {.header = std::move(header), .pattern = std::move(pattern)};
}
/// A column for both.
inline Column both(std::string name, std::string header, std::string pattern = "{}") {
  return {.name = std::move(name), .header = std::move(header), .pattern = std::move(pattern)};
}

struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<Value>> rows;
};

/// A column of a table of `Row`s, and the function that gives its values.
template <class Row>
struct Field {
  Column column;
  std::function<Value(const Row&)> value;
};

template <class Row>
Table table_of(const std::vector<Field<Row>>& fields, const std::vector<Row>& rows) {
  Table table;
  for (const Field<Row>& field : fields) table.columns.push_back(field.column);
  for (const Row& row : rows) {
    std::vector<Value>& line = table.rows.emplace_back();
    for (const Field<Row>& field : fields) line.push_back(field.value(row));
  }
  return table;
}

/// Makes a table of these columns of a list of records. A value is null where a record lacks it.
Table chosen(const nlohmann::json& records, std::vector<Column> columns);

/// Makes a table of words, for people alone.
Table words(const std::vector<std::string>& headers,
            const std::vector<std::vector<std::string>>& rows);

/// A list with one {"name": value, ...} per row, from the columns that have a name.
nlohmann::json records(const Table& table);

/// Whether any column has a name.
bool is_for_programs(const Table& table);

/// CSV (RFC 4180) of the columns that have a name. null becomes an empty field, and flags become 0
/// or 1.
std::string csv(const Table& table);

/// A table in Markdown of the columns for people.
std::string markdown(const Table& table);

/// Aligned columns for people. No line is longer than `width` (0: no limit). Where the columns need
/// more room, words wrap within their columns. Where that is not enough, the most dispensable
/// columns are left out, the last one first among equals. A line below names them.
std::string aligned(const Table& table, std::size_t width);

}  // namespace eerie::text
