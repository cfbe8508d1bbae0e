#pragma once

#include <filesystem>

namespace eerie::test {

/// The program under test.
std::filesystem::path program();

/// The folder that holds README.md.
std::filesystem::path source_folder();

}  // namespace eerie::test
