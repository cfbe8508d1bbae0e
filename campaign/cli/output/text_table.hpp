#pragma once

#include <string>
#include <vector>

namespace eerie::cli {

/// Rows of text in aligned columns; the first row is the header. Columns of numbers align right.
std::string text_table(const std::vector<std::vector<std::string>>& rows);

/// "3 min 20 s", "2.5 h": for people.
std::string duration(double seconds);

/// "1.9e+06" as "1.9 M": for people.
std::string magnitude(double number);

/// "warning: ..." for each, on standard error.
void print_warnings(const std::vector<std::string>& warnings);

}  // namespace eerie::cli
