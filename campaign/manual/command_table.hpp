#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace eerie::manual {

/// An option, or an argument that is known by its place.
struct CommandOption {
  std::vector<std::string> names;    ///< "-o", "--output"; one word without dash: by its place
  std::string value;                 ///< "FLOAT"; empty: a flag
  std::vector<std::string> choices;  ///< words that its value may be; empty: any
  std::string limits;                ///< "1 to 4096"; empty: none
  std::string default_value;         ///< empty: none, or one that the meaning tells
  std::string meaning;
  bool required = false, repeats = false;

  bool is_positional() const { return names.front().front() != '-'; }
  /// A value that may be the name of a file.
  bool may_be_file() const { return value == "TEXT" && choices.empty(); }
};

/// A command, or the program itself, as the command line knows it; without what it hides.
struct CommandPage {
  std::string name;  ///< "eerie", "run", "export"
  std::string meaning;
  std::string footer;  ///< examples, exit codes
  std::vector<CommandOption> options;
  std::vector<CommandPage> commands;
};

CommandPage described(const CLI::App& app);

}  // namespace eerie::manual
