#pragma once

#include <filesystem>
#include <string_view>

#include "campaign/text/given_folder.hpp"

namespace eerie::cli {

/// text::make_given_folder for that of a database, once its name is known to be one of a file.
void make_folder_of_database(const std::filesystem::path& database);

/// install_text() in a folder that is there. Throws InputError where it is not.
void install(const std::filesystem::path& file, std::string_view text);

}  // namespace eerie::cli
