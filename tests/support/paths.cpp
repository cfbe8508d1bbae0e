#include "tests/support/paths.hpp"

namespace eerie::test {

std::filesystem::path program() { return EERIE_PROGRAM; }
std::filesystem::path source_folder() { return EERIE_SOURCE_DIR; }

}  // namespace eerie::test
