#include "campaign/text/given_folder.hpp"

#include <fmt/format.h>

#include "solver/base/error.hpp"
#include "solver/base/files/folders.hpp"

namespace eerie::text {
namespace fs = std::filesystem;

namespace {

/// "here/" and "here" are one folder.
fs::path without_slash(const fs::path& folder) {
  return folder.has_filename() ? folder : folder.parent_path();
}

void require(const fs::path& folder, const fs::path& wanted) {
  std::error_code ignored;
  if (folder.empty() || fs::is_directory(folder, ignored)) return;
  throw InputError(fmt::format("{}: there is no folder {}; make it (mkdir -p) or give another",
                               wanted.string(), folder.string()));
}

}  // namespace

void require_folder_of(const fs::path& file) { require(file.parent_path(), file); }

void require_folder_above(const fs::path& folder) {
  require(without_slash(folder).parent_path(), folder);
}

void make_given_folder(const fs::path& folder) {
  if (folder.empty()) return;
  require_folder_above(folder);
  try {
    make_folders(folder);
  } catch (const EnvironmentError& error) {
    throw EnvironmentError(fmt::format("{}; give another", error.what()));
  }
}

}  // namespace eerie::text
