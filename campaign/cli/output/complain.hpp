#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eerie::cli {

/// To standard error, made plain, its lines kept. Nobody reads it: no reason to stop.
void complain(std::string_view text);

/// "warning: ..." for each.
void print_warnings(const std::vector<std::string>& warnings);

}  // namespace eerie::cli
