#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/proof/waves.hpp"

namespace eerie::proof {
namespace {

TEST(RiemannProblem, HasTheTabulatedSolutionOfSodsTube) {
  // Toro (2009), table 4.2, test 1, in SI.
  const Gas middle = riemann(Sod::left, Sod::right, Sod::gamma, 0);
  EXPECT_NEAR(middle.p, 0.30313e5, 1);
  EXPECT_NEAR(middle.v, 9.2745, 1e-3);
  EXPECT_NEAR(middle.rho, 426.32, 0.01);
  EXPECT_NEAR(riemann(Sod::left, Sod::right, Sod::gamma, 9.28).rho, 265.57, 0.01);
}

TEST(SodTube, FollowsTheExactSolutionAndKeepsItsEnergy) {
  const Sod sod = sod_tube(40, 1.6);
  RecordProperty("error_rho", std::to_string(sod.error_rho));
  RecordProperty("error_v", std::to_string(sod.error_v));
  // A jump smeared over 4 h has the mean error jump x h; the shock's h is 0.03 of the tube.
  EXPECT_LT(sod.error_rho, 0.03);
  EXPECT_LT(sod.error_p, 0.03);
  EXPECT_LT(sod.error_v, 0.06);
  // Pair forces and heats cancel; what the leapfrog leaves is of second order in its step.
  EXPECT_LT(std::abs(sod.energy_drift), 1e-3);
}

TEST(StandingWaves, HaveTheSpeedsOfTheoryLessWhatSmoothingTakes) {
  for (const Wave wave : {Wave::longitudinal, Wave::shear}) {
    const double ratio = wave_speed_ratio(wave, 16);
    RecordProperty(wave == Wave::shear ? "shear" : "longitudinal", std::to_string(ratio));
    EXPECT_NEAR(ratio, 1, 0.03);
    // The next order of smoothing, (k h)^4, is 0.01.
    EXPECT_NEAR(ratio, expected_speed_ratio(wave, 16), 0.005);
  }
}

}  // namespace
}  // namespace eerie::proof
