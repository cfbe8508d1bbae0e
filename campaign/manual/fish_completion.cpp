#include <fmt/format.h>

#include <algorithm>

#include "campaign/manual/completion.hpp"

namespace eerie::manual {
namespace {

/// Within single quotes.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string names_of(const CommandOption& option) {
  std::string out;
  for (const std::string& name : option.names)
    out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return out;
}

std::string value_of(const CommandOption& option) {
  if (option.value.empty()) return "";
  if (option.may_be_file()) return " -r -F";
  if (option.choices.empty()) return " -x";
  return fmt::format(" -x -a '{}'", fmt::join(option.choices, " "));
}

/// Lines for what may stand where `condition` holds.
std::string lines(const std::string& condition, const CommandPage& page) {
  std::string out;
  const std::string begin = fmt::format("complete -c eerie -n '{}'", condition);
  const auto takes_file = [](const CommandOption& option) {
    return option.is_positional() && option.may_be_file();
  };
  if (std::ranges::any_of(page.options, takes_file)) out += begin + " -F\n";
  for (const CommandOption& option : page.options)
    if (!option.is_positional())
      out += fmt::format("{}{}{} -d '{}'\n", begin, names_of(option), value_of(option),
                         plain(option.meaning));
  return out;
}

}  // namespace

std::string fish_completion(const CommandPage& program) {
  std::string out = "# fish completion of eerie, made by `eerie manual`.\ncomplete -c eerie -f\n" +
                    lines("__fish_use_subcommand", program);
  for (const CommandPage& command : program.commands) {
    out += fmt::format("complete -c eerie -n __fish_use_subcommand -a {} -d '{}'\n", command.name,
                       plain(command.meaning));
    const std::string seen = "__fish_seen_subcommand_from " + command.name;
    out += lines(seen, command);
    for (const CommandPage& inner : command.commands) {
      out += fmt::format("complete -c eerie -n '{}' -a {} -d '{}'\n", seen, inner.name,
                         plain(inner.meaning));
      out += lines(seen + "; and __fish_seen_subcommand_from " + inner.name, inner);
    }
  }
  return out;
}

}  // namespace eerie::manual
