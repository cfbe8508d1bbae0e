#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

namespace eerie::text {

/// Whether a spreadsheet takes a text for a formula. Such a text begins with = + - @ or a control
/// character, and is no number.
inline bool is_formula(const std::string& text) {
  if (text.empty() || std::string_view("=+-@\t\r").find(text[0]) == std::string_view::npos)
    return false;
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  const bool number = text.find_first_not_of("+-.0123456789eE") == std::string::npos;
  return !(number && end == text.c_str() + text.size());
}

/// A field of a CSV file in quotation marks, with inner ones doubled (RFC 4180). An apostrophe
/// precedes a text that spreadsheets would take for a formula; parse_csv() removes it.
inline std::string csv_quoted(const std::string& text) {
  std::string out = is_formula(text) ? "\"'" : "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

/// A field of a CSV file. It has quotation marks only where it needs them, and where it could be
/// taken for a comment.
inline std::string csv_field(const std::string& text) {
  const bool bare = text.find_first_of(",;\"\r\n") == std::string::npos && !text.starts_with('#');
  return bare && !is_formula(text) ? text : csv_quoted(text);
}

/// A number with six digits; an empty text where there is none.
inline std::string csv_number(std::optional<double> value) {
  return value ? fmt::format("{:.6g}", *value) : "";
}

}  // namespace eerie::text
