#pragma once

#include <filesystem>

namespace eerie::text {

/// Throws InputError where the folder of a file that is to be written does not exist. A path with
/// a typo must end as a message, not as folders; so none is made for a file.
void require_folder_of(const std::filesystem::path& file);

/// The same of the folder above a folder.
void require_folder_above(const std::filesystem::path& folder);

/// Makes a folder that the user named as such (solve --out, converge -o), or in which a
/// campaign is to live (--db), and flushes its entry. Those above it must be there: throws
/// InputError otherwise, EnvironmentError where it cannot be made.
void make_given_folder(const std::filesystem::path& folder);

}  // namespace eerie::text
