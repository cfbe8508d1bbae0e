#include "analysis/disk/collisions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace eerie::disk {
namespace {

/// The share of collisions below `v_imp`, by numbers: velocities are drawn, and each counts by the
/// rate at which it collides, its speed times its cross-section.
double share_by_drawing(const CollisionSpeeds& c, double v_imp) {
  std::mt19937_64 dice(7);
  std::normal_distribution<double> component(0, c.dispersion);
  double below = 0, all = 0;
  for (int n = 0; n < 400000; ++n) {
    const double v = std::hypot(component(dice), component(dice), component(dice));
    const double rate = v * (1 + c.v_esc * c.v_esc / (v * v));
    all += rate;
    if (v * v + c.v_esc * c.v_esc < v_imp * v_imp) below += rate;
  }
  return below / all;
}

TEST(Collisions, HaveTheSpeedsThatDrawnVelocitiesHave) {
  for (const double dispersion : {0.02, 0.1, 0.5}) {
    const CollisionSpeeds speeds{dispersion, 0.061};
    for (const double v_imp : {0.07, 0.15, 0.4, 1.0})
      EXPECT_NEAR(speeds.share_below(v_imp), share_by_drawing(speeds, v_imp), 5e-3)
          << dispersion << ' ' << v_imp;
  }
}

TEST(Collisions, AreNeverSlowerThanTheEscapeSpeed) {
  const CollisionSpeeds speeds{0.1, 0.061};
  EXPECT_EQ(speeds.share_below(0.061), 0);
  EXPECT_EQ(speeds.share_below(0.03), 0);
  EXPECT_NEAR(speeds.share_below(10), 1, 1e-12);
}

TEST(Collisions, HaveTheirMedianWhereHalfOfThemAre) {
  const CollisionSpeeds speeds{0.1, 0.061};
  EXPECT_NEAR(speeds.share_below(speeds.median()), 0.5, 1e-9);
  // Without gravity the density is v^3 exp(-v^2 / 2 s^2), of median s sqrt(2 * 1.67835).
  EXPECT_NEAR((CollisionSpeeds{1, 0}.median()), std::sqrt(2 * 1.6783469900), 1e-6);
}

TEST(Collisions, AreMostOftenAtHalfARightAngle) {
  EXPECT_NEAR(share_below_angle(std::numbers::pi / 4), 0.5, 1e-12);
  EXPECT_NEAR(share_below_angle(std::numbers::pi / 2), 1, 1e-12);
}

}  // namespace
}  // namespace eerie::disk
