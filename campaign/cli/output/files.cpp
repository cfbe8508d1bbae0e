#include "campaign/cli/output/files.hpp"

#include "db/store/place.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

void make_folder_of_database(const fs::path& database) {
  text::make_given_folder(db::resolved(database).parent_path());
}

void install(const fs::path& file, std::string_view text) {
  text::require_folder_of(file);
  install_text(file, text);
}

}  // namespace eerie::cli
