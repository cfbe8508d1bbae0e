#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace eerie {

/// Free bytes for us on the disk of a folder; nothing where nobody can tell.
std::optional<std::uintmax_t> free_bytes(const std::filesystem::path& folder);

/// Whether so many bytes can be written in a folder now: tried, since quotas are in no table.
bool has_room(const std::filesystem::path& folder, std::uintmax_t bytes);

}  // namespace eerie
