#include "analysis/pictures/bitmap.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/base/constants.hpp"

namespace eerie::pictures {
namespace {

constexpr drawing::Colour white{255, 255, 255}, red{200, 0, 0}, blue{0, 0, 200};

TEST(Bitmap, DiscLiesWhereItsCentreIsCountedFromTheLowerLeftCorner) {
  const std::vector<Disc> discs = {{5.5, 2.5, 2, red}};
  const Bitmap image = painted(discs, 20, 10);
  EXPECT_EQ(image.rgb.size(), 600u);
  EXPECT_EQ(image.at(5, 7), red);  // third row from below
  EXPECT_EQ(image.at(5, 2), white);
  EXPECT_EQ(image.at(14, 7), white);
}

TEST(Bitmap, InkOfADiscIsItsArea) {
  for (const double radius : {0.5, 2.0, 2.9}) {
    const std::vector<Disc> discs = {{20.3, 19.8, radius, {0, 0, 0}}};
    const Bitmap image = painted(discs, 40, 40);
    double ink = 0;
    for (const std::uint8_t value : image.rgb) ink += (255 - value) / (3 * 255.0);
    // The circle's edge crosses some 2 pi 3 r samples of 1/9 of a pixel, each in or out.
    EXPECT_NEAR(ink, pi * radius * radius, 0.5 * std::sqrt(2 * pi * 3 * radius) / 9 + 0.05)
        << radius;
  }
}

TEST(Bitmap, LaterDiscsLieOnTop) {
  const std::vector<Disc> discs = {{4.5, 5.5, 2, red}, {6.5, 5.5, 2, blue}};
  const Bitmap image = painted(discs, 12, 10);
  EXPECT_EQ(image.at(6, 4), blue);
  EXPECT_EQ(image.at(3, 4), red);
}

TEST(Bitmap, WideDiscsHaveADarkerRimAndTinyOnesDoNotVanish) {
  const std::vector<Disc> discs = {{20.5, 20.5, 10, red}, {2.5, 2.5, 0.01, blue}};
  const Bitmap image = painted(discs, 40, 40);
  EXPECT_EQ(image.at(20, 20), red);
  EXPECT_LT(image.at(29, 19).r, red.r);
  EXPECT_EQ(image.at(29, 19).g, 0);
  EXPECT_NE(image.at(2, 37), white);
}

TEST(Bitmap, DiscsMayHangOverEveryBorder) {
  const std::vector<Disc> discs = {
      {-1, 5, 3, red}, {11, 5, 3, red}, {5, -1, 3, red}, {5, 11, 3, red}, {1e9, -1e9, 3, red}};
  EXPECT_EQ(painted(discs, 10, 10).rgb.size(), 300u);
}

TEST(Bitmap, ScaleRunsFromItsFirstColourToItsLast) {
  const Bitmap image = scale_image(1000, 2);
  const drawing::Colour first = drawing::quantity_colour(0), last = drawing::quantity_colour(1);
  EXPECT_NEAR(image.at(0, 0).r, first.r, 1);
  EXPECT_NEAR(image.at(999, 1).g, last.g, 1);
}

}  // namespace
}  // namespace eerie::pictures
