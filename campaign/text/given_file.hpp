#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace eerie::text {

/// Whole content of what the user named: a file, a pipe or device, or "-" for standard input.
/// Throws InputError, also for more than `most_bytes`: a device may never end.
std::string read_given(const std::filesystem::path& path, std::size_t most_bytes);

/// Its name for people: "standard input" for "-".
std::string given_name(const std::filesystem::path& path);

/// Whether it has a name of its own, from which others can be made: not so a pipe or device.
bool is_named_file(const std::filesystem::path& path);

}  // namespace eerie::text
