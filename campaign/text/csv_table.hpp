#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::text {

/// A CSV file (RFC 4180) with a header. The parser also accepts fields separated by semicolons or
/// tabs, empty lines, a byte order mark, and comments. A line above the header is a comment if it
/// begins with #; a line below it must also have no second field. Fields that begin with '= '+ '-
/// or '@, as csv_field() writes formulas, lose the apostrophe.
struct CsvTable {
  struct Row {
    std::size_t line = 0;  ///< number of the line in the file, from 1
    std::vector<std::string> fields;
  };
  std::vector<std::string> header;
  std::vector<Row> rows;  ///< each with as many fields as the header
};

/// Reads a CSV file. Throws InputError, which names `name`, line and fault.
CsvTable parse_csv(std::string_view text, const std::string& name);

}  // namespace eerie::text
