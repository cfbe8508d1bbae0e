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

/// What to say of anything else that the parser threw at: option, value, what is allowed, and where
/// the options are listed. For options of the kinds that commands use: ranges, words, whole
/// numbers.
std::string wrong_use(const CLI::App& app, const CLI::ParseError& error);

}  // namespace eerie::manual
