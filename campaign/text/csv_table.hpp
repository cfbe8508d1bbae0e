#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::text {

/// A CSV file (RFC 4180) with a header. Also read: fields parted by semicolons or tabs instead,
/// lines of comment that begin with #, empty lines, a byte order mark.
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
