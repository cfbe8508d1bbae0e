#include "campaign/text/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/text/csv.hpp"
#include "solver/base/error.hpp"

namespace eerie::text {
namespace {

/// The fields from `at` to the end of their record, and moves `at` and `line` behind it. Quoted
/// fields may hold ends of lines.
std::vector<std::string> record(std::string_view text, char separator, std::size_t& at,
                                std::size_t& line, const std::string& name) {
  const std::size_t first_line = line;
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quoted) {
      if (c == '\n') ++line;
      if (c != '"')
        fields.back() += c;
      else if (at + 1 < text.size() && text[at + 1] == '"')
        fields.back() += c, ++at;
      else
        quoted = false;
    } else if (c == '"' && fields.back().empty()) {
      quoted = true;
    } else if (c == separator) {
      fields.emplace_back();
    } else if (c == '\n') {
      break;
    } else if (c != '\r') {
      fields.back() += c;
    }
  }
  if (quoted)
    throw InputError(
        fmt::format("{}, line {}: a quotation mark is never closed; close it, or "
                    "double it where it belongs to the text",
                    name, first_line));
  ++at, ++line;
  return fields;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

/// "'=1+1" as csv_field() has it is "=1+1".
std::string without_apostrophe(const std::string& text) {
  const bool formula = text.starts_with('\'') && is_formula(text.substr(1));
  return formula ? text.substr(1) : text;
}

/// What the first line that is no comment parts its fields by.
char separator_of(std::string_view header) {
  char best = ',';
  for (const char c : {';', '\t'})
    if (std::ranges::count(header, c) > std::ranges::count(header, best)) best = c;
  return best;
}

}  // namespace

CsvTable parse_csv(std::string_view text, const std::string& name) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  CsvTable table;
  char separator = ',';
  std::size_t line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view whole = text.substr(at, end - at);
    const std::size_t letter = whole.find_first_not_of(" \t\r");
    const bool marked = letter != std::string_view::npos && whole[letter] == '#';
    // Below the header "#7,20,15" is the line of an impact named #7.
    const bool comment =
        marked && (table.header.empty() || whole.find(separator) == std::string_view::npos);
    if (letter == std::string_view::npos || comment) {
      at = end + 1, ++line;
      continue;
    }
    const std::size_t here = line;
    if (table.header.empty()) separator = separator_of(whole);
    std::vector<std::string> fields = record(text, separator, at, line, name);
    for (std::string& field : fields) field = without_apostrophe(trimmed(field));
    if (table.header.empty()) {
      table.header = std::move(fields);
    } else if (fields.size() == table.header.size()) {
      table.rows.push_back({here, std::move(fields)});
    } else {
      throw InputError(
          fmt::format("{}, line {}: has {} fields and the header has {}; quote fields "
                      "that hold a comma, leave unknown ones empty{}",
                      name, here, fields.size(), table.header.size(),
                      marked ? ", and put comments above the header" : ""));
    }
  }
  if (table.header.empty())
    throw InputError(name +
                     ": has no header; its first line must name the columns, for example "
                     "v_imp_m_per_s,theta_imp_deg,m_target_kg,m_projectile_kg");
  return table;
}

}  // namespace eerie::text
