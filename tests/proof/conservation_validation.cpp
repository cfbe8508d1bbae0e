#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/proof/impact.hpp"

namespace eerie::proof {
namespace {

TEST(EnergyBudget, OfAnImpactClosesInEveryVariant) {
  // Every term of the energy equation is the exact partner of one in the momentum equation; what
  // is left is the error of the time step, of second order: a scheme with longer ones has more.
  for (const char* gradient : {"corrected", "corrected-rate", "plain"})
    for (const char* smoothing : {"constant", "evolving"}) {
      const ImpactEnd end = followed(
          impact_scene(300, {{"material", {{"energy", "integrated"}}},
                             {"impact", {{"separation", 1.3}}},
                             {"numerics",
                              {{"gradient", gradient}, {"smoothing", smoothing}, {"cfl", 0.5}}}}),
          1500);
      ASSERT_FALSE(end.failed) << end.failure;
      EXPECT_LT(std::abs(end.energy_drift), 1e-3) << gradient << ", " << smoothing;
      // The two ways of losing motion are both there, and together most of what was lost.
      const double lost = end.first.kinetic_energy - end.last.kinetic_energy;
      EXPECT_GT(end.last.viscous_heat, 0.1 * lost);
      EXPECT_GT(end.last.friction_heat, 0.05 * lost);
      EXPECT_NEAR((end.last.viscous_heat + end.last.friction_heat) / end.last.internal_energy, 1,
                  0.05);
    }
}

TEST(EnergyBudget, TheEnergyEquationDoesNotMoveAColdImpact) {
  // 0.005 J/kg in Tillotson's thermal term changes the density by a part in a thousand.
  const auto length = [](const char* energy) {
    const ImpactEnd end = followed(
        impact_scene(300, {{"material", {{"energy", energy}}}, {"impact", {{"separation", 1.3}}}}),
        1500);
    return end.largest().shape.a;
  };
  EXPECT_NEAR(length("integrated") / length("none"), 1, 0.03);
}

TEST(AngularMomentum, IsKeptByCohesiveRubbleThatBreaks) {
  // Forces are dual to the gradient of velocity, which is exact for a rotation wherever a particle
  // has neighbours on all sides. Where it hangs on few, cohesion has ended, or bodies would turn
  // themselves: by 0.03, 0.3 and 0.9 of their angular momentum here.
  for (const double cohesion_Pa : {1.0, 1e3, 1e12}) {
    const ImpactEnd end = followed(
        impact_scene(400, {{"material", {{"drucker_prager", {{"cohesion_Pa", cohesion_Pa}}}}},
                           {"impact", {{"separation", 1.3}}}}),
        3000);
    ASSERT_FALSE(end.failed) << end.failure;
    EXPECT_LT(end.angular_momentum_drift, 1e-3) << cohesion_Pa;
  }
}

}  // namespace
}  // namespace eerie::proof
