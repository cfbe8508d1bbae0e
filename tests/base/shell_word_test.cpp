#include "solver/base/text/shell_word.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

namespace eerie {
namespace {

/// What a shell makes of a word.
std::string read_by_shell(const std::string& word) {
  const std::string command = "printf %s " + word;
  FILE* shell = ::popen(command.c_str(), "r");
  std::string text;
  std::array<char, 256> part{};
  for (std::size_t n; (n = std::fread(part.data(), 1, part.size(), shell)) > 0;)
    text.append(part.data(), n);
  ::pclose(shell);
  return text;
}

TEST(ShellWord, IsReadByAShellAsItWasMeant) {
  for (const std::string word :
       {"plain", "a/b.json", "two words", "it's", "$HOME", "`id`",  "a;b", "*",        "\\", "\"",
        "(x)",   "#no",      "~",         "-x",   "a\nb",  "{a,b}", "!x",  "v=[1, 2]", "",   "'"})
    EXPECT_EQ(read_by_shell(shell_word(word)), word) << word;
}

TEST(ShellWord, IsMadeOfLettersThatEveryTerminalShows) {
  for (const std::string word :
       {"a\xff.sqlite", "two\nlines", "\x1b[31mred", "100% \t of '\\'", "\u202etxt.exe"}) {
    const std::string written = shell_word(word);
    for (const char c : written) EXPECT_TRUE(c >= ' ' && c <= '~') << written;
    EXPECT_EQ(read_by_shell(written), word) << written;
  }
}

TEST(ShellWord, StaysAsItIsWhereNoShellMinds) {
  for (const std::string word : {"a/b.json", "end.time_s=1e5", "name@2", "0:0.3"})
    EXPECT_EQ(shell_word(word), word);
}

}  // namespace
}  // namespace eerie
