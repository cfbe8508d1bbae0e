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

/// Like install_text(), without a flush to the disk: for what only readers at work need. After a
/// power cut the file may be old, empty or gone.
void show_text(const std::filesystem::path& path, std::string_view text);

/// Adds a text to the end of a file that exists, without a flush: bytes may be lost in a power cut
/// until flush_file() has returned, in part or whole. Throws EnvironmentError and takes back what
/// it has written on failure.
void append_text(const std::filesystem::path& path, std::string_view text);

/// Flushes what was written to a file to the disk. Throws EnvironmentError.
void flush_file(const std::filesystem::path& path);

/// Lists the temporary files of install_file() in a folder. They belong to a writer at work, or to
/// one that was killed. The list is empty where the folder cannot be read.
std::vector<std::filesystem::path> half_written_files(const std::filesystem::path& folder);

/// Renames `from` over `to` in the same folder and flushes the folder to the disk. Throws
/// EnvironmentError.
void replace_file(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace eerie
