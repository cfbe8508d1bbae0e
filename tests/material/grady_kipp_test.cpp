#include "solver/material/grady_kipp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/scenes.hpp"

namespace eerie::material {
namespace {

const Scene::Material basalt = test::small_scene(test::stiff_basalt()).material;
constexpr double volume = 1e-3;  // m^3

Flaws dealt(std::size_t particles, std::uint64_t seed = 1) {
  Random random(seed, 2);
  return GradyKipp(basalt).deal(particles, volume, random);
}

TEST(Flaws, EveryParticleHasOneAndTheyRise) {
  const Flaws flaws = dealt(1000);
  for (std::size_t id = 0; id < 1000; ++id) {
    ASSERT_FALSE(flaws[id].empty());
    EXPECT_TRUE(std::is_sorted(flaws[id].begin(), flaws[id].end()));
  }
}

TEST(Flaws, AreThoseOfTheWholeVolumeInWeibullsDistribution) {
  const Flaws flaws = dealt(1000);
  std::vector<double> all = flaws.strain;
  std::sort(all.begin(), all.end());
  // n(eps) = k V eps^m: flaw j, counted from one, is the j-th that activates.
  for (std::size_t j = 0; j < all.size(); j += 97)
    EXPECT_NEAR(basalt.grady_kipp.k_per_m3 * volume * std::pow(all[j], basalt.grady_kipp.m),
                static_cast<double>(j + 1), 1e-9 * static_cast<double>(j + 1));
  // Coupon collector: n (ln n + 0.577) flaws until each of n particles has one, scatter 1.28 n.
  EXPECT_NEAR(static_cast<double>(all.size()), 1000 * (std::log(1000.0) + 0.577), 4 * 1280);
}

TEST(Flaws, SeedDecidesWhoGetsWhich) {
  EXPECT_EQ(dealt(100, 1).strain, dealt(100, 1).strain);
  EXPECT_NE(dealt(100, 1).strain, dealt(100, 2).strain);
}

TEST(GradyKipp, CracksGrowAtTheirSpeedAndVolumesAdd) {
  const GradyKipp law(basalt);
  const std::vector<double> flaws{1e-4, 2e-4, 3e-4, 4e-4, 5e-4, 6e-4, 7e-4, 8e-4};
  EXPECT_EQ(law.growth(0.5e-4, flaws, 5000, 0.1), 0);
  // One crack runs through R_s in R_s/(0.4 c_l); eight fill it in half the time.
  EXPECT_DOUBLE_EQ(law.growth(1.5e-4, flaws, 5000, 0.1), 0.4 * 5000 / 0.1);
  EXPECT_DOUBLE_EQ(law.growth(1e-3, flaws, 5000, 0.1), 2 * 0.4 * 5000 / 0.1);
}

TEST(GradyKipp, DamageReachesNoFurtherThanItsActiveFlawsAndNeverHeals) {
  const GradyKipp law(basalt);
  const std::vector<double> flaws{1e-4, 2e-4, 3e-4, 4e-4};
  EXPECT_DOUBLE_EQ(law.grown(0, 1.5e-4, flaws, 5000, 0.1, 1), std::cbrt(0.25));
  EXPECT_DOUBLE_EQ(law.grown(0, 1e-3, flaws, 5000, 0.1, 1), 1);
  EXPECT_DOUBLE_EQ(law.grown(0.9, 1.5e-4, flaws, 5000, 0.1, 1), 0.9);
  EXPECT_DOUBLE_EQ(law.grown(0.3, 0, flaws, 5000, 0.1, 1), 0.3);
}

}  // namespace
}  // namespace eerie::material
