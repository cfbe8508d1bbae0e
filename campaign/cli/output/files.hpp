#pragma once

#include <filesystem>

namespace eerie::cli {

/// Makes the folder of a file that is to be written. Throws EnvironmentError.
void make_folder_of(const std::filesystem::path& file);

}  // namespace eerie::cli
