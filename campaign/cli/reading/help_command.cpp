#include "campaign/cli/options/command_list.hpp"
#include "campaign/manual/help_text.hpp"

namespace eerie::cli {

Action add_help(CLI::App& app) {
  auto words = std::make_shared<std::vector<std::string>>();
  app.add_option("COMMAND", *words, "a command, and a command within it (default: the program)");
  return [words, program = app.get_parent()](Output&) {
    Answer answer;
    answer.add_text(manual::help_text(*program, *words));
    return answer;
  };
}

}  // namespace eerie::cli
