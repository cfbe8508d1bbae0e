#include "campaign/cli/output/files.hpp"

#include "analysis/drawing/gnuplot.hpp"
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

namespace {
bool is_table(const fs::path& file) { return file.extension() == ".csv"; }
}  // namespace

void require_tables_or_figures(const std::vector<fs::path>& files) {
  for (const fs::path& file : files)
    if (!is_table(file)) drawing::require_figure_file(file);
}

void write_tables_or_figures(const std::vector<fs::path>& files, const text::Table& table,
                             const std::function<void(const fs::path&)>& draw) {
  for (const fs::path& file : files) {
    text::require_folder_of(file);
    if (is_table(file))
      install_text(file, text::csv(table));
    else
      draw(file);
  }
}

}  // namespace eerie::cli
