#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace eerie {

/// Whole content of a file. Throws EnvironmentError naming the path and the reason.
std::string read_file(const std::filesystem::path& path);

/// Installs a file so that a reader sees the old content or the new, never a part:
/// `write` fills a temporary file in the same folder, which is then fsynced, renamed over
/// `path`, and the folder fsynced. Throws EnvironmentError and removes the temporary on failure.
void install_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path& temporary)>& write);

/// install_file for text that is at hand.
void install_text(const std::filesystem::path& path, std::string_view text);

}  // namespace eerie
