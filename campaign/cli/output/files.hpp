#pragma once

#include <filesystem>
#include <string_view>

namespace eerie::cli {

/// Makes the folder of a file that is to be written. Throws EnvironmentError.
void make_folder_of(const std::filesystem::path& file);

/// install_text(), in a folder that is made where there is none.
void install(const std::filesystem::path& file, std::string_view text);

}  // namespace eerie::cli
