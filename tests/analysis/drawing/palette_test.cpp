#include "analysis/drawing/palette.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace eerie::drawing {
namespace {

TEST(Palette, LightnessRisesWithBOverA) {
  for (int k = 1; k <= 100; ++k)
    EXPECT_GT(lightness(b_over_a_colour(k / 100.0)), lightness(b_over_a_colour((k - 1) / 100.0)))
        << k;
}

TEST(Palette, EersAreBlueAndOthersAreNot) {
  for (int k = 0; k <= 100; ++k) {
    const Colour c = b_over_a_colour(k / 100.0);
    EXPECT_EQ(c.b > c.r, k < 30) << k;
  }
}

TEST(Palette, TextStandsOutOnEveryFill) {
  for (int k = 0; k <= 100; ++k) {
    const Colour fill = b_over_a_colour(k / 100.0);
    EXPECT_GT(std::abs(lightness(fill) - lightness(text_colour(fill))), 44) << k;
  }
}

TEST(Palette, AnchorsComeBackExactly) {
  EXPECT_EQ(hex(b_over_a_colour(0)), "#0b2a66");
  EXPECT_EQ(hex(b_over_a_colour(1)), "#fdf6dc");
  EXPECT_EQ(b_over_a_colour(-3), b_over_a_colour(0));
  EXPECT_EQ(b_over_a_colour(7), b_over_a_colour(1));
}

TEST(Palette, LightnessOfQuantitiesRisesEvenlyAndStandsOutOnWhite) {
  const double first = lightness(quantity_colour(0)), last = lightness(quantity_colour(1));
  EXPECT_LT(last, 87);
  for (int k = 1; k <= 100; ++k) {
    const double here = lightness(quantity_colour(k / 100.0));
    EXPECT_GT(here, lightness(quantity_colour((k - 1) / 100.0))) << k;
    EXPECT_NEAR(here, first + (last - first) * k / 100, 5) << k;
  }
}

TEST(Palette, LightnessOfKnownColours) {
  EXPECT_NEAR(lightness({255, 255, 255}), 100, 1e-3);
  EXPECT_EQ(lightness({0, 0, 0}), 0);
  EXPECT_NEAR(lightness({119, 119, 119}), 50.03, 0.05);
}

}  // namespace
}  // namespace eerie::drawing
