#include "campaign/text/layout.hpp"

#include <gmock/gmock.h>

namespace eerie::text {
namespace {
using testing::ElementsAre;

TEST(TextTable, AlignsNumbersRightAndWordsLeft) {
  EXPECT_EQ(text_table({{"v", "class"}, {"5", "a"}, {"15", "merge"}}),
            " v  class\n"
            " 5  a\n"
            "15  merge\n");
  EXPECT_EQ(text_table({{"x"}, {"-5"}, {"10"}}), " x\n-5\n10\n");
}

TEST(WidthOf, CountsColumnsOfATerminalAndNotBytes) {
  EXPECT_EQ(width_of("m/s"), 3u);
  EXPECT_EQ(width_of("\xc2\xb1 5"), 3u) << "plus-minus has two bytes";
  EXPECT_EQ(width_of("\xe5\xb0\x8f\xe6\x83\x91"), 4u) << "ideographs take two columns";
  EXPECT_EQ(width_of("e\xcc\x81"), 1u) << "an accent stands on its letter";
}

TEST(Cut, NeverTakesMoreThanItMayNorHalfALetter) {
  EXPECT_EQ(cut("short", 5), "short");
  EXPECT_EQ(cut("a longer text", 8), "a lon...");
  for (std::size_t width = 0; width < 12; ++width) {
    const std::string text =
        cut("\xe5\xb0\x8f\xe6\x83\x91\xe6\x98\x9f\xe5\xb0\x8f\xe6\x83\x91", width);
    EXPECT_LE(width_of(text), width);
    EXPECT_EQ(text.find("\xef\xbf\xbd"), std::string::npos);
  }
}

TEST(Wrapped, PartsLinesBetweenWordsAndWordsOnlyWhereTheyMustBe) {
  EXPECT_THAT(wrapped("one two three", 8), ElementsAre("one two", "three"));
  EXPECT_THAT(wrapped("abcdefghij", 4), ElementsAre("abcd", "efgh", "ij"));
  EXPECT_THAT(wrapped("", 4), ElementsAre(""));
  EXPECT_THAT(wrapped("ab", 1), ElementsAre("a", "b"));
}

TEST(TextTable, WrapsCellsWithinTheirColumn) {
  EXPECT_EQ(text_table({{"n", "what"}, {"1", "one two three"}, {"2", "x"}}, {1, 7}),
            "n  what\n"
            "1  one two\n"
            "   three\n"
            "2  x\n");
}

}  // namespace
}  // namespace eerie::text
