#pragma once

#include <filesystem>

namespace eerie {

/// Makes a folder, with those above it, and has the disk know all of them: an entry that is not
/// flushed into the folder above can be lost in a power cut with everything in it. Throws
/// EnvironmentError.
void make_folders(const std::filesystem::path& folder);

}  // namespace eerie
