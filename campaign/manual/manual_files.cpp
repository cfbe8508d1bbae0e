#include "campaign/manual/manual_files.hpp"

#include "campaign/manual/completion.hpp"
#include "campaign/manual/man_page.hpp"

namespace eerie::manual {

std::vector<ManualFile> manual_files(const CommandPage& program, const std::string& version) {
  std::vector<ManualFile> files;
  files.push_back({"man/eerie.1", program_page(program, version)});
  for (const CommandPage& command : program.commands)
    files.push_back({"man/eerie-" + command.name + ".1", command_page(command, version)});
  files.push_back({"completions/eerie", bash_completion(program)});
  files.push_back({"completions/_eerie", zsh_completion(program)});
  files.push_back({"completions/eerie.fish", fish_completion(program)});
  return files;
}

}  // namespace eerie::manual
