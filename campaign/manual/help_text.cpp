#include "campaign/manual/help_text.hpp"

#include "campaign/manual/mistakes.hpp"
#include "solver/base/error.hpp"

namespace eerie::manual {

std::string help_text(const CLI::App& program, const std::vector<std::string>& words) {
  const CLI::App* page = &program;
  std::string name = program.get_name();
  for (const std::string& word : words) {
    if (const std::string fault = unknown_command(*page, word); !fault.empty())
      throw InputError(fault);
    page = page->get_subcommand(word);
    name += " " + word;
  }
  // Not page->help(): that of the program would be that of the command which asks.
  return page->get_formatter()->make_help(page, name, CLI::AppFormatMode::Normal);
}

}  // namespace eerie::manual
