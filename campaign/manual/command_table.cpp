#include "campaign/manual/command_table.hpp"

#include <fmt/format.h>

#include <sstream>

namespace eerie::manual {
namespace {

/// What stands between two letters, or nothing.
std::string between(const std::string& text, char first, char last) {
  const std::size_t begin = text.find(first), end = text.find(last);
  if (begin == std::string::npos || end == std::string::npos || end < begin) return "";
  return text.substr(begin + 1, end - begin - 1);
}

std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');) words.push_back(word);
  return words;
}

std::string limits_of(const std::string& type) {
  std::string limits = between(type, '[', ']');
  if (const std::size_t at = limits.find(" - "); at != std::string::npos)
    limits.replace(at, 3, " to ");
  return limits;
}

CommandOption described(const CLI::Option& option) {
  CommandOption entry;
  for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  if (entry.names.empty()) entry.names.push_back(option.get_name(true));
  // "TEXT:{results,remnants,maps}", "INT:INT in [1 - 4096]"
  const std::string type = option.get_type_name();
  if (option.get_type_size_max() > 0) entry.value = type.substr(0, type.find(':'));
  entry.choices = words_of(between(type, '{', '}'));
  entry.limits = limits_of(type);
  entry.default_value = option.get_default_str();
  entry.meaning = option.get_description();
  entry.required = option.get_required();
  entry.repeats = option.get_items_expected_max() > 1;
  return entry;
}

}  // namespace

CommandPage described(const CLI::App& app) {
  CommandPage page{app.get_name(), app.get_description(), app.get_footer(), {}, {}};
  for (const CLI::Option* option : app.get_options())
    if (!option->get_group().empty()) page.options.push_back(described(*option));
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_group().empty()) page.commands.push_back(described(*command));
  return page;
}

}  // namespace eerie::manual
