#include "analysis/light_curve/shadow.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/base/constants.hpp"
#include "tests/analysis/remnants/bodies.hpp"

namespace eerie::light_curve {
namespace {

const Vec3 oblique{0.3, -0.8, 0.5};

TEST(Shadow, OneSphereThrowsADisc) {
  const std::vector<Vec3> one = {{1e3, -2e3, 5}};
  for (const Vec3& along : {Vec3{0, 0, 1}, Vec3{0, 3, 0}, oblique})
    EXPECT_NEAR(shadow_area(one, 7, along), pi * 49, 0.005 * pi * 49);
  EXPECT_EQ(shadow_area({}, 7, oblique), 0);
}

TEST(Shadow, OverlapIsCountedOnce) {
  // Two discs of radius 1 at distance d share 2 acos(d/2) - d sqrt(1 - d^2/4).
  for (const double d : {0.0, 0.7, 1.6, 2.5}) {
    const std::vector<Vec3> two = {{0, 0, 0}, {d, 0, 40}};
    const double shared = d < 2 ? 2 * std::acos(d / 2) - d * std::sqrt(1 - d * d / 4) : 0;
    EXPECT_NEAR(shadow_area(two, 1, {0, 0, 1}), 2 * pi - shared, 0.03) << d;
  }
}

TEST(Shadow, SpheresBehindEachOtherThrowOneDisc) {
  const std::vector<Vec3> row = {{0, 0, 0}, 10.0 * oblique, -25.0 * oblique};
  EXPECT_NEAR(shadow_area(row, 1, oblique), pi, 0.005 * pi);
}

TEST(Shadow, LongSpansFillWholeWords) {
  // A line of overlapping discs: a stadium, hundreds of pixels long.
  std::vector<Vec3> line;
  for (int i = 0; i <= 1000; ++i) line.push_back({0.1 * i, 0, 0});
  EXPECT_NEAR(shadow_area(line, 1, {0, 0, 1}), 200 + pi, 0.2);
}

TEST(Shadow, OppositeDirectionsSeeOneArea) {
  const auto x = test::ellipsoid({30, 20, 10}, 4);
  EXPECT_NEAR(shadow_area(x, 2.5, oblique), shadow_area(x, 2.5, -oblique), 2);
}

TEST(Shadow, FinerPixelsConverge) {
  const auto x = test::moved(test::ellipsoid({50, 30, 20}, 4), test::rotation(oblique, 0.4), {});
  const double exact = shadow_area(x, 2.5, oblique, 200);
  EXPECT_LT(std::abs(shadow_area(x, 2.5, oblique, 3) / exact - 1), 3e-3);
  EXPECT_LT(std::abs(shadow_area(x, 2.5, oblique) / exact - 1), 5e-4);
  EXPECT_LT(std::abs(shadow_area(x, 2.5, oblique, 48) / exact - 1), 1e-4);
}

}  // namespace
}  // namespace eerie::light_curve
