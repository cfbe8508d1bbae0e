#pragma once

#include <string>
#include <vector>

namespace eerie::test {

/// What stands between ```LANGUAGE and ``` in a page, block by block.
std::vector<std::string> code_blocks(const std::string& markdown, const std::string& language);

/// All of it as one text.
std::string code_of(const std::string& markdown, const std::string& language);

}  // namespace eerie::test
