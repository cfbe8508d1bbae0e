#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::drawing {

/// A program of the system that eerie runs for some task.
struct Tool {
  std::string program;
  std::string use;      ///< "draws the maps"
  std::string package;  ///< the Debian package that contains it
};

struct ToolEnd {
  bool well = false;  ///< whether it ended by itself with status 0
  std::string words;  ///< its standard error
};

/// Runs a program without a shell. `input` goes to its standard input, and its standard output into
/// the file `output` (nowhere where that is empty). Throws EnvironmentError where it is not
/// installed (with the package to install) or cannot be started.
ToolEnd run_tool(const Tool& tool, const std::vector<std::string>& arguments,
                 std::string_view input = {}, const std::filesystem::path& output = {});

/// Throws the same EnvironmentError where PATH has no such program. It starts nothing.
void require_tool(const Tool& tool);

}  // namespace eerie::drawing
