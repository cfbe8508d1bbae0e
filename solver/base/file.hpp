#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace eerie {

/// Reads a whole file. Throws EnvironmentError, which names the path and the reason.
std::string read_file(const std::filesystem::path& path);

/// Installs a file so that a reader sees the old content or the new, never a part:
/// `write` fills a temporary file in the same folder, which is then fsynced, renamed over
/// `path`, and the folder fsynced. Where `previous` is given, the former file keeps that name. It
/// is renamed after the new file is on the disk, so one of the two is whole at every instant.
/// Throws EnvironmentError and removes the temporary on failure.
void install_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path& temporary)>& write,
                  const std::filesystem::path& previous = {});

/// install_file() for a text in memory.
void install_text(const std::filesystem::path& path, std::string_view text,
                  const std::filesystem::path& previous = {});

/// Lists the temporary files of install_file() in a folder. They belong to a writer at work, or to
/// one that was killed. The list is empty where the folder cannot be read.
std::vector<std::filesystem::path> half_written_files(const std::filesystem::path& folder);

/// Renames `from` over `to` in the same folder and flushes the folder to the disk. Throws
/// EnvironmentError.
void replace_file(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace eerie
