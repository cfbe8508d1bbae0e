#include "campaign/cli/output/files.hpp"

#include <fmt/format.h>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

void make_folder_of(const fs::path& file) {
  if (!file.has_parent_path()) return;
  std::error_code problem;
  fs::create_directories(file.parent_path(), problem);
  if (problem)
    throw EnvironmentError(fmt::format("cannot make the folder {}: {}; give another file",
                                       file.parent_path().string(), problem.message()));
}

void install(const fs::path& file, std::string_view text) {
  make_folder_of(file);
  install_text(file, text);
}

}  // namespace eerie::cli
