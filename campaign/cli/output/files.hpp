#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

#include "campaign/text/given_folder.hpp"
#include "campaign/text/table.hpp"

namespace eerie::cli {

/// text::make_given_folder for that of a database, once its name is known to be one of a file.
void make_folder_of_database(const std::filesystem::path& database);

/// install_text() in a folder that is there. Throws InputError where it is not.
void install(const std::filesystem::path& file, std::string_view text);

/// Throws InputError for a file that is to be neither a table (.csv) nor a figure.
void require_tables_or_figures(const std::vector<std::filesystem::path>& files);
/// Writes the table into each .csv and lets `draw` make the others, in folders that are there.
void write_tables_or_figures(const std::vector<std::filesystem::path>& files,
                             const text::Table& table,
                             const std::function<void(const std::filesystem::path&)>& draw);

}  // namespace eerie::cli
