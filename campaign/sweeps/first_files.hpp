#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace eerie::sweeps {

struct FirstFile {
  std::string name, content;
};

/// A command that can be pasted, and what it does.
struct FirstCommand {
  std::string command, meaning;
};

/// The files that someone begins with, and the commands to type next. There are a sweep with
/// comments, a scene, and the schemas of both, by which editors complete and check them.
struct FirstFiles {
  std::vector<FirstFile> files;
  std::vector<FirstCommand> next;
};
FirstFiles first_files(const std::filesystem::path& folder);

/// JSON Schemas for editors, indented. That of a sweep has all fields of the scene, and all axes by
/// name. Both take "$schema" and comments, which the program leaves out (comments.hpp).
std::string scene_schema_for_editors();
std::string sweep_schema_for_editors();

}  // namespace eerie::sweeps
