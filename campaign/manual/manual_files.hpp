#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/manual/command_table.hpp"

namespace eerie::manual {

struct ManualFile {
  std::filesystem::path path;  ///< from the manual's folder on
  std::string text;
};

/// man/eerie.1, man/eerie-COMMAND.1, and completions/{eerie,_eerie,eerie.fish}.
std::vector<ManualFile> manual_files(const CommandPage& program, const std::string& version);

}  // namespace eerie::manual
