#include "campaign/text/plain_text.hpp"

#include <gtest/gtest.h>

#include "solver/base/utf8.hpp"

using eerie::text::plain_lines;
using eerie::text::plain_text;

namespace {

TEST(PlainText, OrdinaryTextStaysAsItIs) {
  for (const std::string text : {"", "a b", "θ = 45°, M_{lr} 'x' \"y\" `z` $(w) \\n", "日本語 😀"})
    EXPECT_EQ(plain_text(text), text);
}

TEST(PlainText, ControlCharactersAreShown) {
  EXPECT_EQ(plain_text("a\nb\rc\td"), "a\\nb\\rc\\td");
  EXPECT_EQ(plain_text("\x1b[2J\x1b]0;title\x07"), "\\x1b[2J\\x1b]0;title\\x07");
  EXPECT_EQ(plain_text(std::string("a\0b\x7f", 4)), "a\\x00b\\x7f");
  EXPECT_EQ(plain_text("\u009b2J"), "\\x9b2J");  // the C1 form of ESC [
  EXPECT_EQ(plain_text("a\u202eb\u2028"), "a\\u202eb\\u2028");
}

TEST(PlainText, BytesThatAreNoUtf8AreReplaced) {
  EXPECT_EQ(plain_text("a\x9b"
                       "2J\xff"),
            "a\ufffd2J\ufffd");
}

TEST(PlainText, SeveralLinesKeepTheirEndsAndNothingElse) {
  EXPECT_EQ(plain_lines("a\nb\r\n\x1b[0m"), "a\nb\\r\n\\x1b[0m");
}

TEST(PlainText, EveryByteComesOutWithoutControlsAndASecondTimeTheSame) {
  for (int first = 0; first < 256; ++first)
    for (int second = 0; second < 256; ++second) {
      const std::string text{static_cast<char>(first), static_cast<char>(second)};
      const std::string plain = plain_text(text);
      for (std::size_t at = 0; at < plain.size();) {
        const eerie::Letter letter = eerie::letter_at(plain, at);
        EXPECT_TRUE(letter.valid && !eerie::is_control(letter.code));
        at += letter.bytes.size();
      }
      EXPECT_EQ(plain_text(plain), plain);
    }
}

}  // namespace
