#pragma once

#include <string>

#include "campaign/manual/command_table.hpp"

namespace eerie::manual {

// Scripts that complete commands, options and the words that options take. Where any word will do
// the shell's own completion of file names goes on.

std::string bash_completion(const CommandPage& program);
std::string zsh_completion(const CommandPage& program);
std::string fish_completion(const CommandPage& program);

}  // namespace eerie::manual
