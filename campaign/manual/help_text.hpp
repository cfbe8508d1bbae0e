#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace eerie::manual {

/// What --help prints for the command that these words name, such as {"catalogue", "import"}; for
/// the program without any. Throws InputError where there is no such command.
std::string help_text(const CLI::App& program, const std::vector<std::string>& words);

}  // namespace eerie::manual
