#include "campaign/text/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "campaign/text/csv.hpp"
#include "campaign/text/layout.hpp"
#include "campaign/text/plain_text.hpp"

namespace eerie::text {
namespace {

using Cells = std::vector<std::vector<std::string>>;

std::string text_for_people(const Value& value, const Column& column) {
  if (value.is_null()) return "-";
  if (value.is_boolean()) return value.get<bool>() ? column.mark : "";
  if (value.is_string()) return plain_text(value.get<std::string>());
  const auto pattern = fmt::runtime(column.pattern);
  return value.is_number_float() ? fmt::format(pattern, value.get<double>())
         : column.pattern == "{}"
             ? fmt::format("{}", value.get<std::int64_t>())
             : fmt::format(pattern, static_cast<double>(value.get<std::int64_t>()));
}

std::string csv_text(const Value& value) {
  if (value.is_null()) return "";
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  return value.is_string() ? csv_field(value.get<std::string>()) : value.dump();
}

bool is_shared(const Table& table, std::size_t column) {
  return std::ranges::all_of(table.rows, [&](const std::vector<Value>& row) {
    return row[column] == table.rows.front()[column];
  });
}

/// What all rows share, "q 1, phi_d 40 deg"; and the places of the columns that differ.
std::pair<std::string, std::vector<std::size_t>> parted(const Table& table) {
  std::string above;
  std::vector<std::size_t> below;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const Column& column = table.columns[c];
    if (!column.for_people) continue;
    if (!column.above || table.rows.empty() || !is_shared(table, c)) {
      below.push_back(c);
    } else if (const Value& value = table.rows.front()[c]; !value.is_null()) {
      above += fmt::format("{}{} {}{}", above.empty() ? "" : ", ", column.header,
                           text_for_people(value, column), column.unit_above);
    }
  }
  return {above, below};
}

Cells cells_of(const Table& table, const std::vector<std::size_t>& chosen) {
  Cells cells(1);
  for (const std::size_t c : chosen) cells[0].push_back(plain_text(table.columns[c].header));
  for (const std::vector<Value>& row : table.rows) {
    std::vector<std::string>& line = cells.emplace_back();
    for (const std::size_t c : chosen) line.push_back(text_for_people(row[c], table.columns[c]));
  }
  return cells;
}

std::size_t sum_of(const std::vector<std::size_t>& widths) {
  std::size_t sum = widths.empty() ? 0 : 2 * (widths.size() - 1);
  for (const std::size_t width : widths) sum += width;
  return sum;
}

/// Widths with which the rows take no more than `width`, of which words are the first to give
/// way; nothing where not even that is enough.
std::optional<std::vector<std::size_t>> fitting_widths(const Cells& cells, std::size_t width) {
  constexpr std::size_t least = 12;
  std::vector<std::size_t> widths = widths_of(cells);
  std::vector<bool> gives_way(widths.size());
  for (std::size_t c = 0; c < widths.size(); ++c) gives_way[c] = !is_numeric(cells, c);
  while (sum_of(widths) > width) {
    std::size_t widest = widths.size();
    for (std::size_t c = 0; c < widths.size(); ++c)
      if (gives_way[c] && widths[c] > least &&
          (widest == widths.size() || widths[c] > widths[widest]))
        widest = c;
    if (widest == widths.size()) return std::nullopt;
    --widths[widest];
  }
  return widths;
}

/// The column that is missed least.
std::size_t least_missed(const Table& table, const std::vector<std::size_t>& chosen) {
  std::size_t found = chosen.size() - 1;
  for (std::size_t k = chosen.size(); k-- > 1;)
    if (table.columns[chosen[k]].dispensable > table.columns[chosen[found]].dispensable) found = k;
  return found;
}

}  // namespace

Table chosen(const nlohmann::json& records, std::vector<Column> columns) {
  Table table{std::move(columns), {}};
  for (const nlohmann::json& record : records) {
    std::vector<Value>& row = table.rows.emplace_back();
    for (const Column& column : table.columns) row.push_back(record.value(column.name, Value()));
  }
  return table;
}

Table words(const std::vector<std::string>& headers, const Cells& rows) {
  Table table;
  for (const std::string& header : headers) table.columns.push_back(shown(header));
  for (const auto& row : rows) table.rows.emplace_back(row.begin(), row.end());
  return table;
}

nlohmann::json records(const Table& table) {
  nlohmann::json list = nlohmann::json::array();
  for (const std::vector<Value>& row : table.rows) {
    nlohmann::json record = nlohmann::json::object();
    for (std::size_t c = 0; c < row.size(); ++c)
      if (!table.columns[c].name.empty()) record[table.columns[c].name] = row[c];
    list.push_back(std::move(record));
  }
  return list;
}

bool is_for_programs(const Table& table) {
  return std::ranges::any_of(table.columns,
                             [](const Column& column) { return !column.name.empty(); });
}

std::string csv(const Table& table) {
  std::vector<std::string> fields;
  for (const Column& column : table.columns)
    if (!column.name.empty()) fields.push_back(csv_field(column.name));
  std::string text = fmt::format("{}\n", fmt::join(fields, ","));
  for (const std::vector<Value>& row : table.rows) {
    fields.clear();
    for (std::size_t c = 0; c < row.size(); ++c)
      if (!table.columns[c].name.empty()) fields.push_back(csv_text(row[c]));
    text += fmt::format("{}\n", fmt::join(fields, ","));
  }
  return text;
}

std::string markdown(const Table& table) {
  std::string text;
  auto cells = cells_of(table, parted(table).second);
  for (auto& row : cells) {
    for (std::string& cell : row)
      for (std::size_t at = 0; (at = cell.find('|', at)) != std::string::npos; at += 2)
        cell.insert(at, "\\");
    const bool is_header = text.empty();
    text += fmt::format("| {} |\n", fmt::join(row, " | "));
    if (is_header)
      text += "|" + fmt::format("{}", fmt::join(std::vector<std::string>(row.size(), "---"), "|")) +
              "|\n";
  }
  return text;
}

std::string aligned(const Table& table, std::size_t width) {
  if (table.rows.empty()) return "";
  auto [above, chosen] = parted(table);
  std::string text;
  if (!above.empty())
    for (const std::string& line : wrapped(above, width == 0 ? above.size() : width))
      text += line + "\n";
  if (!above.empty()) text += "\n";
  if (width == 0 || chosen.empty()) return text + text_table(cells_of(table, chosen));
  std::vector<std::string> left_out;
  std::optional<std::vector<std::size_t>> widths;
  while (!(widths = fitting_widths(cells_of(table, chosen), width)) && chosen.size() > 1) {
    const std::size_t least = least_missed(table, chosen);
    left_out.push_back(table.columns[chosen[least]].header);
    chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(least));
  }
  text += text_table(cells_of(table, chosen), widths.value_or(std::vector{width}));
  std::erase(left_out, "");
  std::ranges::reverse(left_out);
  if (!left_out.empty())
    for (const std::string& line :
         wrapped(fmt::format("(no room for: {})", fmt::join(left_out, ", ")), width))
      text += line + "\n";
  return text;
}

}  // namespace eerie::text
