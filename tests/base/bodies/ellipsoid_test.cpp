#include "solver/base/bodies/ellipsoid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"

namespace eerie {
namespace {

constexpr double rho = 2700;

/// A_x of semi-axes (x, y, z) by its definition, xyz int_0^inf du / ((x^2 + u) Delta), with
/// u = t^2/(1 - t)^2 and the rule of midpoints.
double by_definition(double x, double y, double z) {
  constexpr int parts = 20000;
  double sum = 0;
  for (int n = 0; n < parts; ++n) {
    const double t = (n + 0.5) / parts, u = t * t / ((1 - t) * (1 - t));
    const double du = 2 * t / ((1 - t) * (1 - t) * (1 - t)) / parts;
    sum += du / ((x * x + u) * std::sqrt((x * x + u) * (y * y + u) * (z * z + u)));
  }
  return x * y * z * sum;
}

TEST(AttractionCoefficients, AreTwoThirdsForASphereAndAddUpToTwo) {
  const Vec3 sphere = attraction_coefficients({7, 7, 7});
  EXPECT_NEAR(sphere.x, 2.0 / 3, 1e-14);
  EXPECT_NEAR(sphere.z, 2.0 / 3, 1e-14);
  for (const Vec3& axes : {Vec3{1, 0.5, 0.3}, Vec3{10, 9, 1}, Vec3{3, 1, 0.999}}) {
    const Vec3 A = attraction_coefficients(axes);
    EXPECT_NEAR(A.x + A.y + A.z, 2, 1e-13);
  }
}

TEST(AttractionCoefficients, AreThoseOfSpheroidsInClosedForm) {
  for (const double e : {0.3, 0.8, 0.99}) {
    const double f = std::sqrt(1 - e * e);
    const double long_axis =
        f * f / (e * e * e) * std::log((1 + e) / (1 - e)) - 2 * f * f / (e * e);
    EXPECT_NEAR(attraction_coefficients({1, f, f}).x, long_axis, 1e-12) << e;
    const double short_axis = 2 / (e * e) - 2 * f / (e * e * e) * std::asin(e);
    EXPECT_NEAR(attraction_coefficients({1, 1, f}).z, short_axis, 1e-12) << e;
  }
}

TEST(AttractionCoefficients, AreTheIntegralsOfTheirDefinition) {
  const Vec3 a = {1, 0.45, 0.3}, A = attraction_coefficients(a);
  EXPECT_NEAR(A.x, by_definition(a.x, a.y, a.z), 1e-6);
  EXPECT_NEAR(A.y, by_definition(a.y, a.z, a.x), 1e-6);
  EXPECT_NEAR(A.z, by_definition(a.z, a.x, a.y), 1e-6);
}

TEST(NeededFriction, IsNoneForTheFiguresOfAFluid) {
  // Where the Jacobi ellipsoids branch off the Maclaurin spheroids: e = 0.81267 and
  // Omega^2/(pi G rho) = 0.37423 (Chandrasekhar 1969).
  const double e = 0.81267, omega = std::sqrt(0.37423 * pi * newton_G * rho);
  EXPECT_NEAR(needed_friction({1, 1, std::sqrt(1 - e * e)}, rho, omega), 0, 1e-4);
  EXPECT_NEAR(needed_friction({1, 1, 1}, rho, 0), 0, 1e-14);
}

TEST(NeededFriction, OfASphereIsThatOfItsFastestSpin) {
  for (const double mu : {0.2, 0.84, 1.19}) {
    EXPECT_NEAR(needed_friction({50, 50, 50}, rho, fastest_spin(rho, mu)) / mu, 1, 1e-12) << mu;
  }
  // 36 deg and more: the equator lifts off before the inside yields.
  EXPECT_TRUE(std::isinf(needed_friction({1, 1, 1}, rho, 1.01 * fastest_spin(rho, 100))));
}

TEST(NeededFriction, GrowsWithTheLengthOfABodyAtRestAndIsLessWithSomeSpin) {
  const auto needed = [](double b_over_a, double period_h) {
    return needed_friction({1, b_over_a, b_over_a}, rho,
                           period_h == 0 ? 0 : 2 * pi / (3600 * period_h));
  };
  EXPECT_LT(needed(0.8, 0), needed(0.5, 0));
  EXPECT_LT(needed(0.5, 0), needed(0.2, 0));
  EXPECT_LT(needed(0.3, 8), needed(0.3, 0));
}

}  // namespace
}  // namespace eerie
