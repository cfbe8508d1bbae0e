#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>

namespace eerie::text {

/// A field of a CSV file in quotation marks, those within it doubled (RFC 4180).
inline std::string csv_quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

/// The same, quoted only where it must be.
inline std::string csv_field(const std::string& text) {
  return text.find_first_of(",\"\r\n") == std::string::npos ? text : csv_quoted(text);
}

/// A number with six digits; empty where there is none.
inline std::string csv_number(std::optional<double> value) {
  return value ? fmt::format("{:.6g}", *value) : "";
}

}  // namespace eerie::text
