#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace eerie {

/// The bytes that this user may still write on the disk of a folder; nothing where the system does
/// not say it.
std::optional<std::uintmax_t> free_bytes(const std::filesystem::path& folder);

/// Whether so many bytes can be written in a folder now. The function tries it, since no table
/// lists quotas.
bool has_room(const std::filesystem::path& folder, std::uintmax_t bytes);

}  // namespace eerie
