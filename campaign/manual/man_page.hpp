#pragma once

#include <string>

#include "campaign/manual/command_table.hpp"

namespace eerie::manual {

/// A page of section 1 in the man macros. `version` stands in its foot.
std::string program_page(const CommandPage& program, const std::string& version);
std::string command_page(const CommandPage& command, const std::string& version);

}  // namespace eerie::manual
