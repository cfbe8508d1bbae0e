#pragma once

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

#include "analysis/drawing/script.hpp"
#include "solver/base/file.hpp"

namespace eerie::bench {

/// The numbers of a CSV file below its header as a data block of gnuplot's; words are NaN.
inline drawing::Script data_block(drawing::Literal name, const std::filesystem::path& csv) {
  drawing::Script block = drawing::script("{} << EOD\n", name);
  std::istringstream lines(read_file(csv));
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line);) {
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) {
      char* end = nullptr;
      const double number = std::strtod(field.c_str(), &end);
      const bool whole = !field.empty() && end == field.c_str() + field.size();
      block += drawing::script("{} ", whole ? number : std::nan(""));
    }
    block += "\n";
  }
  return block + "EOD\n";
}

}  // namespace eerie::bench
