#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace eerie {

/// Whole content of a file. Throws EnvironmentError naming the path and the reason.
std::string read_file(const std::filesystem::path& path);

/// Installs a file so that a reader sees the old content or the new, never a part:
/// `write` fills a temporary file in the same folder, which is then fsynced, renamed over
/// `path`, and the folder fsynced. Where `previous` is given, a former file goes on under that
/// name: it is renamed after the new one is on the disk, so one of the two is whole at every
/// instant. Throws EnvironmentError and removes the temporary on failure.
void install_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path& temporary)>& write,
                  const std::filesystem::path& previous = {});

/// install_file for text that is at hand.
void install_text(const std::filesystem::path& path, std::string_view text,
                  const std::filesystem::path& previous = {});

/// The temporary files of install_file in a folder: of a writer at work, or of one that was killed.
/// None where the folder cannot be read.
std::vector<std::filesystem::path> half_written_files(const std::filesystem::path& folder);

/// Renames `from` over `to` in the same folder, and has the disk know. Throws EnvironmentError.
void replace_file(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace eerie
