#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace eerie::test {

/// A C++ file of the program.
struct SourceFile {
  std::filesystem::path path;  ///< from the folder that holds README.md on
  std::string room;            ///< "solver/step": the first two folders; "campaign" for main.cpp
  std::vector<std::string> lines;
};

/// Every .cpp and .hpp below `tops`.
std::vector<SourceFile> source_files(const std::vector<std::string>& tops);

}  // namespace eerie::test
