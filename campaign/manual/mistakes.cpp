#include "campaign/manual/mistakes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "campaign/manual/command_table.hpp"
#include "campaign/text/closest_names.hpp"

namespace eerie::manual {
namespace {

std::string did_you_mean(const std::vector<std::string>& names) {
  return names.empty() ? "" : fmt::format("; did you mean {}?", fmt::join(names, " or "));
}

/// The command that the parser reached, below the program.
const CLI::App* reached(const CLI::App& app, std::string& name) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    name += " " + command->get_name();
  }
  return command;
}

/// The options that a word likely means. Options for the scene are paths behind --set.
std::vector<std::string> likely_options(const CLI::App& command, const std::string& word,
                                        const std::vector<std::string>& fields) {
  std::vector<std::string> options;
  for (const CommandOption& option : described(command).options)
    for (const std::string& name : option.names)
      if (name.starts_with("--")) options.push_back(name);
  std::vector<std::string> likely = text::likely_names(word, options);
  if (!likely.empty() || std::ranges::find(options, "--set") == options.end()) return likely;
  for (const std::string& field : text::likely_names(word, fields))
    likely.push_back(fmt::format("--set {}=VALUE", field));
  return likely;
}

}  // namespace

std::string unknown_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CommandPage& command : described(app).commands) names.push_back(command.name);
  // Hidden commands are commands too.
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    if (command->get_name() == word) return "";
  return fmt::format(
      "there is no command \"{}\"{} The commands are {}", word,
      text::likely_names(word, names).empty() ? "." : did_you_mean(text::likely_names(word, names)),
      fmt::join(names, ", "));
}

std::string unknown_options(const CLI::App& app, const std::vector<std::string>& fields) {
  std::string name = "eerie", sentences;
  const CLI::App* command = reached(app, name);
  for (const std::string& argument : command->remaining()) {
    if (!argument.starts_with('-')) continue;
    const std::string word = argument.substr(0, argument.find('='));
    sentences += fmt::format("{}`{}` has no option {}{}", sentences.empty() ? "" : "\n", name, word,
                             did_you_mean(likely_options(*command, word, fields)));
  }
  if (!sentences.empty()) sentences += fmt::format("\n`{} --help` lists its options", name);
  return sentences;
}

}  // namespace eerie::manual
