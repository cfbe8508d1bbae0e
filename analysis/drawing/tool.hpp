#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::drawing {

/// A program of the system that eerie has others' work done by.
struct Tool {
  std::string program;
  std::string use;      ///< "draws the maps"
  std::string package;  ///< Debian's, that holds it
};

struct ToolEnd {
  bool well = false;  ///< it ended by itself with status 0
  std::string words;  ///< what it wrote on standard error
};

/// Runs a program without a shell: `input` on its standard input, its standard output into the
/// file `output` (nowhere when empty). Throws EnvironmentError: it is not installed (with the
/// package to install), or cannot be started.
ToolEnd run_tool(const Tool& tool, const std::vector<std::string>& arguments,
                 std::string_view input = {}, const std::filesystem::path& output = {});

/// Throws the same EnvironmentError where PATH holds no such program; starts nothing.
void require_tool(const Tool& tool);

}  // namespace eerie::drawing
