#include "analysis/disk/friction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"

namespace eerie::disk {
namespace {

TEST(CentralPressure, IsTheWeightOfAColumnToTheSurface) {
  constexpr double radius = 50, rho = 2700;
  constexpr int shells = 1000;
  double weight = 0;  // midpoint rule, exact for gravity linear in r
  for (int i = 0; i < shells; ++i) {
    const double r = (i + 0.5) * radius / shells;
    weight += rho * newton_G * rho * sphere_volume(r) / (r * r) * radius / shells;
  }
  EXPECT_NEAR(central_pressure({radius, rho}), weight, 1e-9 * weight);
}

TEST(Displacement, IsWhereFrictionHasTakenWhatTheFragmentsBrought) {
  for (const double radius : {50.0, 1e4})
    for (const double phi_d_deg : {30.0, 45.0, 60.0}) {
      const double mu_d = friction_coefficient(radians(phi_d_deg));
      const double slide = radius * displacement_over_radius_of_sphere(mu_d);
      EXPECT_NEAR(dissipated_energy(radius, 2700, slide, mu_d) / gathering_energy(radius, 2700), 1,
                  1e-12);
    }
}

TEST(GatheringEnergy, IsThatOfAFallFromInfinityOntoTheSurface) {
  constexpr double radius = 80, rho = 2000;
  const double mass = rho * sphere_volume(radius);
  EXPECT_NEAR(gathering_energy(radius, rho), newton_G * mass * mass / radius, 1e-9);
}

// Sec. 3.2, Eq. (5): L/R_r ~ 1/mu_d, hence mu_d >~ 1 or phi_d >~ 45 deg.
TEST(Displacement, ReachesTheRadiusAt45DegreesByThePapersOrderOfMagnitude) {
  EXPECT_NEAR(displacement_over_radius(friction_coefficient(radians(45))), 1, 1e-12);
  EXPECT_GT(displacement_over_radius(friction_coefficient(radians(40))), 1);
  EXPECT_LT(displacement_over_radius(friction_coefficient(radians(50))), 1);
}

// Eqs. (3) and (4) for a sphere have a factor of 8/3 before it: 69 deg, and no factor of order one
// that Eq. (5) leaves out is smaller.
TEST(Displacement, ReachesTheRadiusAt69DegreesByThePapersEquations) {
  const double mu_d = friction_coefficient(radians(69.444));
  EXPECT_NEAR(displacement_over_radius_of_sphere(mu_d), 1, 1e-4);
  EXPECT_NEAR(displacement_over_radius_of_sphere(1) / displacement_over_radius(1), 8.0 / 3, 1e-12);
}

// Sec. 4 has about 10 Pa in a body of 50 m; Eq. (3) gives 2.5 Pa there and 10 Pa at 100 m.
TEST(CentralPressure, IsAFourthOfThePapersTenPascalAt50Metres) {
  EXPECT_NEAR(central_pressure({50, 2700}), 2.55, 0.01);
  EXPECT_NEAR(central_pressure({100, 2700}), 10, 0.5);
}

}  // namespace
}  // namespace eerie::disk
