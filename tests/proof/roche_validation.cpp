#include <gtest/gtest.h>

#include "tests/proof/roche.hpp"

namespace eerie::proof {
namespace {

TEST(RocheEllipsoid, IsThatOfChandrasekharsTables) {
  // Chandrasekhar (1969), section 55: the last of the series, by interpolation of his table.
  const RocheEllipsoid last = roche_ellipsoid(0.09);
  ASSERT_TRUE(last.exists);
  EXPECT_NEAR(last.b_over_a, 0.52, 0.02);
  EXPECT_NEAR(last.c_over_a, 0.49, 0.02);
  EXPECT_FALSE(roche_ellipsoid(0.0905).exists);
  // To first order a - c is 15/4 and a - b 45/16 of the tide.
  const RocheEllipsoid faint = roche_ellipsoid(1e-4);
  EXPECT_NEAR((1 - faint.c_over_a) / 1e-4, 15.0 / 4, 0.01);
  EXPECT_NEAR((1 - faint.b_over_a) / 1e-4, 45.0 / 16, 0.01);
}

TEST(RocheEllipsoid, IsWhatALiquidBodyTakesOnInATide) {
  const LiquidInTide is = liquid_in_tide(0.05, 300, 8000, 2000);
  const RocheEllipsoid theory = roche_ellipsoid(0.05);
  // Smoothing weakens the gravity of 300 particles by a tenth: as if the tide were stronger.
  const RocheEllipsoid weak = roche_ellipsoid(0.05 / 0.9);
  EXPECT_NEAR(is.b_over_a, (theory.b_over_a + weak.b_over_a) / 2, 0.04);
  EXPECT_NEAR(is.c_over_a, (theory.c_over_a + weak.c_over_a) / 2, 0.04);
  EXPECT_LT(is.off_deg, 10);
}

}  // namespace
}  // namespace eerie::proof
