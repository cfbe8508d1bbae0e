#include "tests/support/markdown.hpp"

namespace eerie::test {

std::vector<std::string> code_blocks(const std::string& markdown, const std::string& language) {
  const std::string open = "```" + language + "\n", close = "```";
  std::vector<std::string> blocks;
  for (std::size_t at = markdown.find(open); at != std::string::npos;
       at = markdown.find(open, at)) {
    const std::size_t begin = at + open.size();
    at = markdown.find(close, begin);
    blocks.push_back(markdown.substr(begin, at - begin));
    if (at != std::string::npos) at += close.size();
  }
  return blocks;
}

std::string code_of(const std::string& markdown, const std::string& language) {
  std::string all;
  for (const std::string& block : code_blocks(markdown, language)) all += block;
  return all;
}

}  // namespace eerie::test
