#include <fmt/format.h>

#include <algorithm>

#include "campaign/manual/completion.hpp"

namespace eerie::manual {
namespace {

/// Within single quotes, with what `_arguments` would read as its own marks made plain.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'')
      out += "'\\''";
    else if (c == ':' || c == '[' || c == ']' || c == '\\')
      out += std::string("\\") + c;
    else
      out += c;
  }
  return out;
}

/// What comes after an option: nothing, words, files or a number.
std::string value_of(const CommandOption& option) {
  if (option.value.empty()) return "";
  if (!option.choices.empty())
    return fmt::format(":{}:({})", option.value, fmt::join(option.choices, " "));
  return fmt::format(":{}:{}", option.value, option.may_be_file() ? "_files" : " ");
}

std::string arguments(const CommandPage& page, const std::string& indent) {
  std::string out = indent + "_arguments -S";
  const std::string next = " \\\n" + indent + "  ";
  for (const CommandOption& option : page.options) {
    if (option.is_positional()) {
      out += fmt::format("{}'{}:{}:_files'", next, option.repeats ? "*" : "",
                         plain(option.names.front()));
      continue;
    }
    for (const std::string& name : option.names)
      out += fmt::format("{}'{}{}{}[{}]{}'", next, option.repeats ? "*" : "", name,
                         !option.value.empty() && name.starts_with("--") ? "=" : "",
                         plain(option.meaning), value_of(option));
  }
  return out + "\n";
}

std::string list_of(const CommandPage& page, const std::string& indent) {
  std::string out = indent + "local -a commands\n" + indent + "commands=(\n";
  for (const CommandPage& command : page.commands)
    out += fmt::format("{}  '{}:{}'\n", indent, command.name, plain(command.meaning));
  return out + indent + ")\n" + indent + "_describe -t commands command commands\n";
}

/// A function that completes this page's words; those of commands within are functions, too.
std::string function_of(const std::string& name, const CommandPage& page) {
  std::string inner, out = fmt::format("{}() {{\n", name);
  if (page.commands.empty()) return out + arguments(page, "  ") + "}\n\n";
  out += "  if (( CURRENT == 2 )); then\n" + list_of(page, "    ") + arguments(page, "    ");
  out += "    return\n  fi\n  local chosen=$words[2]\n  shift words\n  (( CURRENT-- ))\n";
  out += "  case $chosen in\n";
  for (const CommandPage& command : page.commands) {
    const std::string its_name = name + "_" + command.name;
    out += fmt::format("    {}) {} ;;\n", command.name, its_name);
    inner += function_of(its_name, command);
  }
  return inner + out + "  esac\n}\n\n";
}

}  // namespace

std::string zsh_completion(const CommandPage& program) {
  return "#compdef eerie\n# zsh completion of eerie, made by `eerie manual`.\n\n" +
         function_of("_eerie", program) + "_eerie \"$@\"\n";
}

}  // namespace eerie::manual
