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

/// A column: for programs under its name, for people under its header.
struct Column {
  std::string name = {};       ///< key of JSON and of CSV, with its unit; empty: for people alone
  std::string header = {};     ///< with its unit
  std::string pattern = "{}";  ///< of its numbers, for people
  std::string unit = {}, meaning = {};  ///< of the name, for programs
  std::string mark = "yes";             ///< a flag that is set, for people
  std::string unit_above = {};          ///< where it stands above the table
  bool for_people = true;
  bool above = false;   ///< where all rows share its value, it stands above the table
  int dispensable = 0;  ///< left out the sooner, the higher, where a terminal is narrow
};

/// For programs alone.
inline Column data(std::string name) { return {.name = std::move(name), .for_people = false}; }
/// For people alone.
inline Column shown(std::string header, std::string pattern = "{}") {
  return {.header = std::move(header), .pattern = std::move(pattern)};
}
/// For both.
inline Column both(std::string name, std::string header, std::string pattern = "{}") {
  return {.name = std::move(name), .header = std::move(header), .pattern = std::move(pattern)};
}

struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<Value>> rows;
};

/// A column of a table of `Row`s, and where its values come from.
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

/// Columns of a list of records, by their names; null where a record lacks one.
Table chosen(const nlohmann::json& records, std::vector<Column> columns);

/// A table for people alone of headers and rows of words.
Table words(const std::vector<std::string>& headers,
            const std::vector<std::vector<std::string>>& rows);

/// One {"name": value, ...} per row, of the columns that have a name.
nlohmann::json records(const Table& table);

/// Whether any column has a name.
bool is_for_programs(const Table& table);

/// RFC 4180 of the columns that have a name. null is an empty field, flags are 0 or 1.
std::string csv(const Table& table);

/// A table of Markdown, of what is for people.
std::string markdown(const Table& table);

/// Aligned columns for people, no line longer than `width` (0: as long as it must be). Where the
/// columns need more, words wrap within theirs; where that is not enough, columns are left out,
/// the most dispensable first, of equals the last; a line below says which.
std::string aligned(const Table& table, std::size_t width);

}  // namespace eerie::text
