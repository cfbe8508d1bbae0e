#include "campaign/manual/mistakes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

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

/// The parts of a text before and after the first `between`, where it has that.
std::optional<std::pair<std::string, std::string>> split_at(const std::string& text,
                                                            const std::string& between) {
  const std::size_t at = text.find(between);
  if (at == std::string::npos) return std::nullopt;
  return std::pair(text.substr(0, at), text.substr(at + between.size()));
}

/// "0.500000" as people write it.
std::string short_number(const std::string& text) {
  return fmt::format("{}", std::strtod(text.c_str(), nullptr));
}

/// What a validator says behind the name of its option.
std::string wrong_value(const std::string& option, const std::string& said) {
  if (const auto range = split_at(said, " not in range "); range && said.starts_with("Value ")) {
    const auto ends = split_at(range->second, " to ");
    const std::string value = range->first.substr(std::string("Value ").size());
    if (ends)
      return fmt::format("{} = {}: must be {} to {}", option, value, short_number(ends->first),
                         short_number(ends->second));
  }
  if (const auto words = split_at(said, " not in {")) {
    std::string list = words->second.substr(0, words->second.find('}'));
    for (std::size_t at = 0; (at = list.find(',', at)) != std::string::npos; at += 2)
      list.replace(at, 1, ", ");
    return fmt::format("{} = {}: must be one of {}", option, words->first, list);
  }
  return fmt::format("{}: {}", option, said);
}

std::string meaning_of(const CLI::App& command, const std::string& option) {
  const CLI::Option* found = command.get_option_no_throw(option);
  return found == nullptr || found->get_description().empty() ? ""
                                                              : ": " + found->get_description();
}

/// A sentence about the mistake, without the command's help.
std::string sentence(const CLI::App& command, const std::string& name,
                     const CLI::ParseError& error) {
  const std::string said = error.what(), kind = error.get_name();
  if (said == "A subcommand is required") return fmt::format("`{}` needs a command", name);
  if (const auto lacks = split_at(said, " is required"); lacks && kind == "RequiredError")
    return fmt::format("`{}` needs {}{}", name, lacks->first, meaning_of(command, lacks->first));
  if (const auto two = split_at(said, " requires "); two && kind == "RequiresError")
    return fmt::format("{} goes with {}; give both, or neither", two->first, two->second);
  if (const auto two = split_at(said, " excludes "); two && kind == "ExcludesError")
    return fmt::format("{} and {} exclude each other; give one", two->first, two->second);
  // Errors of this kind have the name of the command.
  if (said.starts_with("The following argument"))
    return fmt::format("`{}` does not know what to do with {}; it takes no such word", name,
                       fmt::join(command.remaining(), " "));
  if (const auto pair = split_at(said, "Could not convert: "); pair && kind == "ConversionError")
    return pair->second + ": must be a whole number";
  const auto about = split_at(said, ": ");
  if (about && kind == "ArgumentMismatch")
    return fmt::format("{} needs a value{}", about->first, meaning_of(command, about->first));
  if (about && kind == "ValidationError") return wrong_value(about->first, about->second);
  return said;
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

std::string wrong_use(const CLI::App& app, const CLI::ParseError& error) {
  std::string name = "eerie";
  const CLI::App* command = reached(app, name);
  const std::string text = sentence(*command, name, error);
  return fmt::format("{}\n`{} --help` lists its {}", text, name,
                     command->get_subcommands({}).empty() ? "options" : "commands");
}

}  // namespace eerie::manual
