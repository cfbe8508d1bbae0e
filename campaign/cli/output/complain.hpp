#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eerie::cli {

/// Writes plain lines to standard error. A failure to write is no reason to stop.
void complain(std::string_view text);

/// Complains "warning: ..." for each.
void print_warnings(const std::vector<std::string>& warnings);

}  // namespace eerie::cli
