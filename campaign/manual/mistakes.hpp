#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace eerie::manual {

/// What to say of a word that is no command of the program: the commands that are likely meant, and
/// all that there are. Empty where it is a command.
std::string unknown_command(const CLI::App& app, const std::string& word);

/// What to say of the arguments that the parser did not take, after it has thrown: the likely
/// options of the command, and the likely scene fields (of `fields`) for its --set. Empty where the
/// parser took all.
std::string unknown_options(const CLI::App& app, const std::vector<std::string>& fields);

}  // namespace eerie::manual
