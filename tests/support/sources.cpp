#include "tests/support/sources.hpp"

#include <algorithm>
#include <fstream>

#include "tests/support/paths.hpp"

namespace eerie::test {
namespace fs = std::filesystem;

namespace {

std::string room_of(const fs::path& file) {
  const fs::path folder = file.parent_path();
  auto part = folder.begin();
  const std::string top = part->string();
  return ++part == folder.end() ? top : top + "/" + part->string();
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

std::vector<SourceFile> source_files(const std::vector<std::string>& tops) {
  std::vector<SourceFile> files;
  for (const std::string& top : tops)
    for (const auto& entry : fs::recursive_directory_iterator(source_folder() / top)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
      const fs::path path = fs::relative(entry.path(), source_folder());
      files.push_back({path, room_of(path), lines_of(entry.path())});
    }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

}  // namespace eerie::test
