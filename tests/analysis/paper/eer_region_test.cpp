#include "analysis/paper/eer_region.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "solver/base/constants.hpp"

namespace eerie::paper {
namespace {

/// A ridge as those of 40 deg: 0.1 wide in ln(v sin theta) and from 17 to 25 cm/s.
double true_p(double v, double theta) {
  const double across = (std::log(v * std::sin(radians(theta))) - std::log(4.9)) / 0.1,
               along = (std::log(v) - std::log(20.7)) / 0.2;
  return 1 / (1 + std::exp(-3 * (1 - across * across - along * along)));
}

std::vector<EerTrials> campaign(std::size_t runs, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<EerTrials> impacts;
  for (double theta = 7.5; theta <= 20; theta += 2.5)
    for (double v = 15; v <= 30; v += 1) {
      EerTrials t{v, theta, 0, runs};
      for (std::size_t k = 0; k < runs; ++k) t.eers += uniform(random) < true_p(v, theta) ? 1 : 0;
      impacts.push_back(t);
    }
  return impacts;
}

TEST(EerRegion, FindsTheProbabilityOfAKnownRidge) {
  const auto region = eer_region(campaign(40, 1));
  ASSERT_TRUE(region);
  for (double theta = 8; theta <= 20; theta += 0.5)
    for (double v = 15; v <= 30; v += 0.5)
      EXPECT_NEAR(region->at(v, theta).p, true_p(v, theta), 0.12) << v << " " << theta;
}

TEST(EerRegion, ItsIntervalHoldsTheTruthAboutAsOftenAsItSays) {
  int held = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto region = eer_region(campaign(2, seed));
    ASSERT_TRUE(region);
    for (double theta = 9; theta <= 19; theta += 0.5)
      for (double v = 16; v <= 27; v += 0.5) {
        const double truth = true_p(v, theta);
        if (truth < 0.3 || truth > 0.7) continue;  // where the border may lie
        const EerRegion::Probability fit = region->at(v, theta);
        held += fit.low <= truth && truth <= fit.high ? 1 : 0, ++all;
      }
  }
  // 0.68 of independent places; those of one campaign move together, so some eight count.
  EXPECT_GT(held, 0.5 * all) << held << " of " << all;
  EXPECT_LT(held, 0.95 * all) << held << " of " << all;
}

TEST(EerRegion, MoreRunsMakeTheBorderSurer) {
  const auto width = [](std::size_t runs) {
    double sum = 0;
    const auto region = eer_region(campaign(runs, 3));
    if (!region) throw std::runtime_error("no region");
    for (double v = 17; v <= 24; v += 0.5) {
      const auto fit = region->at(v, degrees(std::asin(4.9 * 1.1 / v)));
      sum += fit.high - fit.low;
    }
    return sum;
  };
  // By the root of the number of runs, 0.14, and which impacts are drawn.
  EXPECT_LT(width(100), 0.4 * width(2)) << width(2);
}

TEST(EerRegion, TheSameSeedGivesTheSameBits) {
  const auto impacts = campaign(1, 2);
  const auto a = eer_region(impacts, 5)->at(20, 14), b = eer_region(impacts, 5)->at(20, 14);
  EXPECT_EQ(a.p, b.p);
  EXPECT_EQ(a.low, b.low);
  EXPECT_EQ(a.high, b.high);
}

TEST(EerRegion, HeadOnImpactsChangeNothing) {
  std::vector<EerTrials> impacts = campaign(2, 1);
  const auto without = eer_region(impacts)->at(20, 14);
  for (double v = 15; v <= 30; v += 1) impacts.push_back({v, 0, 0, 2});
  const auto with = eer_region(impacts)->at(20, 14);
  EXPECT_EQ(with.p, without.p);
  EXPECT_EQ(with.low, without.low);
  EXPECT_EQ(with.high, without.high);
}

TEST(EerRegion, TooFewEersOrAllAtOneAngleMakeNone) {
  EXPECT_FALSE(eer_region({}));
  std::vector<EerTrials> three, one_angle;
  for (double v = 15; v <= 30; v += 1)
    for (const double theta : {10.0, 15.0, 20.0}) {
      three.push_back({v, theta, v == 20 ? 1u : 0u, 1});
      one_angle.push_back({v, theta, theta == 15 ? 1u : 0u, 1});
    }
  EXPECT_FALSE(eer_region(three));
  EXPECT_FALSE(eer_region(one_angle));
}

}  // namespace
}  // namespace eerie::paper
