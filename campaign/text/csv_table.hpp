#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::text {

/// A CSV file (RFC 4180) with a header. Also read: fields parted by semicolons or tabs instead,
/// empty lines, a byte order mark, and lines of comment: those above the header that begin with #,
/// and those below it that have no second field besides. Fields that begin with '= '+ '- or '@, as
/// csv_field() writes formulas, are read without the apostrophe.
struct CsvTable {
  struct Row {
    std::size_t line = 0;  ///< in the file, from 1
    std::vector<std::string> fields;
  };
  std::vector<std::string> header;
  std::vector<Row> rows;  ///< as many fields each as the header
};

/// Throws InputError naming `name`, line and fault.
CsvTable parse_csv(std::string_view text, const std::string& name);

}  // namespace eerie::text
