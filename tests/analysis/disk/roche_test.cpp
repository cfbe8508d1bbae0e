#include "analysis/disk/roche.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/disk/ejection.hpp"
#include "solver/base/constants.hpp"

namespace eerie::disk {
namespace {

/// A_1 as Chandrasekhar defines it, a1 a2 a3 times the integral over u of
/// 1 / ((a1^2 + u) Delta), with t = (1 + u / a1^2)^(-1/2); Simpson's rule.
double self_gravity_by_integral(double b_over_a) {
  const double b2 = b_over_a * b_over_a;
  const auto f = [b2](double t) { return 2 * b2 * t * t / (1 - (1 - b2) * t * t); };
  constexpr int n = 20000;
  double sum = f(0) + f(1);
  for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(static_cast<double>(i) / n);
  return sum / (3 * n);
}

TEST(SelfGravityCoefficient, IsChandrasekharsIntegral) {
  for (const double b_over_a : {0.05, 0.1, 0.3, 0.7, 0.97, 0.98, 0.999, 1.0})
    EXPECT_NEAR(self_gravity_coefficient(b_over_a), self_gravity_by_integral(b_over_a), 1e-9)
        << b_over_a;
}

TEST(SelfGravityCoefficient, IsThePapersClosedForm) {
  // Sec. 4.3, Eq. (13).
  for (const double b_over_a : {0.1, 0.24, 0.6}) {
    const double e2 = 1 - b_over_a * b_over_a, e = std::sqrt(e2);
    const double a1 = (1 - e2) / (e2 * e) * std::log((1 + e) / (1 - e)) - 2 * (1 - e2) / e2;
    EXPECT_NEAR(self_gravity_coefficient(b_over_a), a1, 1e-12) << b_over_a;
  }
}

TEST(SelfGravityCoefficient, GoesOnSmoothlyWhereTheSeriesTakesOver) {
  const double join = std::sqrt(0.95);
  EXPECT_NEAR(self_gravity_coefficient(join - 1e-12), self_gravity_coefficient(join + 1e-12),
              1e-11);
}

TEST(RocheDistance, IsWhereTideAndGravityAtTheTipAreEqual) {
  constexpr double rho = 1900, central = 3e5, length = 240;
  for (const double b_over_a : {0.1, 0.5, 1.0}) {
    const double d = central * roche_distance(b_over_a);
    const double tide = newton_G * sphere_volume(central) * rho * length / cubed(d);  // Eq. (11)
    const double gravity =
        pi * newton_G * rho * self_gravity_coefficient(b_over_a) * length;  // Eq. (12)
    EXPECT_NEAR(tide / gravity, 1, 1e-12) << b_over_a;
  }
}

TEST(RocheDistance, IsTheCubeRootOfTwoForASphereAndGrowsWithElongation) {
  EXPECT_NEAR(roche_distance(1), std::cbrt(2.0), 1e-12);
  for (double b_over_a = 0.05; b_over_a < 0.99; b_over_a += 0.01)
    EXPECT_GT(roche_distance(b_over_a), roche_distance(b_over_a + 0.01));
}

// Sec. 4.3: b/a = 0.1 gives d_R = 3.2 R_c.
TEST(RocheDistance, IsThePapersThreePointTwoRadiiForATenthOfAxisRatio) {
  EXPECT_NEAR(roche_distance(0.1), 3.2, 0.05);
}

TEST(HillRadius, BalancesTheTidesOfStarAndPlanetForSmallPlanets) {
  // On a circle in the rotating frame, 3 G M x / a^3 = G m / x^2.
  const double x = hill_radius(2e11, 1e-4);
  EXPECT_NEAR(3 * x / cubed(2e11), 1e-4 / (x * x), 1e-12 * 1e-4 / (x * x));
}

// Sec. 4.3: Jupiter's Hill radius is 740 of its radii. 5.2044 AU, 1/1047.35 of the Sun, 71,492 km.
TEST(HillRadius, IsThePapers740RadiiForJupiter) {
  EXPECT_NEAR(hill_radius(5.2044 * 1.495978707e11, 1 / 1047.35) / 7.1492e7, 740, 5);
}

// Sec. 4.3: a_c = 2.4 a_b around an equal binary on a circle.
TEST(CircumbinaryLimit, IsThePapersTwoPointFourForAnEqualBinary) {
  EXPECT_NEAR(circumbinary_limit(0.5, 0), 2.4, 0.05);
  EXPECT_GT(circumbinary_limit(0.5, 0.5), circumbinary_limit(0.5, 0));
}

}  // namespace
}  // namespace eerie::disk
