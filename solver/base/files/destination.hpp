#pragma once

#include <filesystem>
#include <string_view>

namespace eerie {

/// Where bytes for a path go.
struct Destination {
  std::filesystem::path path;  ///< behind every symbolic link; may not exist yet
  bool is_stream =
      false;  ///< device, pipe, socket or open descriptor: written into, never replaced
};

/// Follows symbolic links to the file that a user means. Throws EnvironmentError for a folder and
/// for links that lead in a circle.
Destination destination_of(const std::filesystem::path& path);

/// Writes all bytes to a descriptor. Returns how many it could write; errno says why not all.
std::size_t write_all(int descriptor, std::string_view bytes);

/// Writes the bytes of the file `from` into a stream. Throws EnvironmentError.
void pour(const std::filesystem::path& from, const std::filesystem::path& stream);

}  // namespace eerie
