#include "analysis/drawing/key.hpp"

#include <gtest/gtest.h>

namespace eerie::drawing {
namespace {

TEST(TextWidth, IsThatOfItsLetters) {
  // DejaVu Sans: i is 0.278, M 0.863 (bold 0.995) of the type size; a subscript is 0.8 as large.
  EXPECT_NEAR(text_width(in_quotes("iM"), 10), 2.78 + 8.63, 1e-9);
  EXPECT_NEAR(text_width(in_quotes("M"), 10, true), 9.95, 1e-9);
  EXPECT_NEAR(text_width(marked_up("i_M"), 10), 2.78 + 0.8 * 8.63, 1e-9);
  EXPECT_NEAR(text_width(marked_up("i_{{Mi}}M"), 10), 2.78 + 0.8 * (8.63 + 2.78) + 8.63, 1e-9);
  EXPECT_NEAR(text_width(in_quotes("a_b{}"), 10), 6.13 + 5 + 6.35 + 2 * 6.36, 1e-9) << "no markup";
  EXPECT_NEAR(size_that_fits(in_quotes("MM"), 8.63, 7), 5, 1e-9);
  EXPECT_EQ(size_that_fits(in_quotes("i"), 100, 7), 7);
}

TEST(Key, BreaksIntoRowsThatThePageCanHold) {
  const Quoted words = in_quotes("MMMMMMMMMM");  // 56 points, with its sample 74
  const std::vector<KeyEntry> four(4, KeyEntry{words, Script("lw 1")});
  EXPECT_EQ(Key(four, 400).height_pt(), Key::row_height);
  EXPECT_EQ(Key(four, 200).height_pt(), 2 * Key::row_height);
  EXPECT_EQ(Key(four, 100).height_pt(), 4 * Key::row_height);
  EXPECT_EQ(Key(four, 10).height_pt(), 4 * Key::row_height) << "too narrow for any";
  EXPECT_EQ(Key({}, 100).height_pt(), 0);
}

}  // namespace
}  // namespace eerie::drawing
