#include <fmt/format.h>

#include "campaign/manual/completion.hpp"

namespace eerie::manual {
namespace {

/// One branch of a `case`: what may stand after this command, and after each of its options.
/// `path` is "run" or "catalogue export"; empty for the program itself.
std::string branch(const std::string& path, const CommandPage& page) {
  std::string commands, options, values;
  for (const CommandPage& command : page.commands) commands += command.name + " ";
  for (const CommandOption& option : page.options) {
    if (option.is_positional()) continue;
    options += fmt::format("{} ", fmt::join(option.names, " "));
    if (option.value.empty()) continue;
    values += fmt::format("      {}) ", fmt::join(option.names, "|"));
    if (option.may_be_file())
      values += "return ;;\n";
    else
      values += fmt::format("words='{}' files= ;;\n", fmt::join(option.choices, " "));
  }
  std::string out = fmt::format("  '{}')\n    words='{}' options='{}'\n", path, commands, options);
  if (!values.empty()) out += "    case $before in\n" + values + "    esac\n";
  return out + "    ;;\n";
}

std::string branches(const std::string& path, const CommandPage& page) {
  std::string out = branch(path, page);
  for (const CommandPage& command : page.commands)
    out += branches(path.empty() ? command.name : path + " " + command.name, command);
  return out;
}

/// Commands that have commands within.
std::string nested(const CommandPage& program) {
  std::string out;
  for (const CommandPage& command : program.commands)
    if (!command.commands.empty()) out += (out.empty() ? "" : "|") + command.name;
  return out.empty() ? "''" : out;
}

constexpr const char* before_branches = R"(# bash completion of eerie, made by `eerie manual`.
_eerie() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}}
  local path= words= options= files=yes
  COMPREPLY=()
  # --of=results is three words to bash.
  if [[ $word == = ]]; then word=; elif [[ $before == = ]]; then before=${{COMP_WORDS[COMP_CWORD-2]}}; fi
  if ((COMP_CWORD > 1)); then path=${{COMP_WORDS[1]}}; fi
  case $path in
    {}) if ((COMP_CWORD > 2)) && [[ ${{COMP_WORDS[2]}} != -* ]]; then path+=" ${{COMP_WORDS[2]}}"; fi ;;
  esac
  case $path in
)";

// Without a reply bash goes on with file names by itself, unless it is told not to.
constexpr const char* after_branches = R"(  esac
  if [[ $word == -* ]]; then words=$options; fi
  if [[ -z $files ]]; then compopt +o default 2> /dev/null; fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o bashdefault -o default -F _eerie eerie
)";

}  // namespace

std::string bash_completion(const CommandPage& program) {
  return fmt::format(before_branches, nested(program)) + branches("", program) + after_branches;
}

}  // namespace eerie::manual
