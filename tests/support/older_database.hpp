#pragma once

#include <filesystem>

namespace eerie::test {

/// Turns a database of this program into what the program with schema 5 would have left.
void make_schema_5(const std::filesystem::path& database);

}  // namespace eerie::test
