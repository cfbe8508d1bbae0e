#include "analysis/figures/size_distribution.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::figures {
namespace {

/// Two impacts with three remnants, two of them alike.
SizeDistribution three_remnants() { return {"survey", 1000, 2, 0.05, {0.9, 0.4, 0.4}}; }

TEST(SizeDistribution, CountsWhatIsAtLeastAsMassivePerImpact) {
  const SizeDistribution d = three_remnants();
  EXPECT_EQ(d.count_from(0.95), 0);
  EXPECT_EQ(d.count_from(0.9), 0.5);
  EXPECT_EQ(d.count_from(0.41), 0.5);
  EXPECT_EQ(d.count_from(0.4), 1.5);
  EXPECT_EQ(d.count_from(0), 1.5);
}

TEST(SizeDistribution, HasAStepForEachMass) {
  const std::vector<SizeStep> all = steps(three_remnants());
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].mass, 0.9);
  EXPECT_EQ(all[0].count, 0.5);
  EXPECT_EQ(all[1].mass, 0.4);
  EXPECT_EQ(all[1].count, 1.5);
}

/// Cumulative counts of masses m_k = k^(-1/alpha) are a power law of exponent -alpha.
TEST(SizeDistribution, OfAPowerLawIsThatPowerLaw) {
  constexpr double alpha = 0.8;
  SizeDistribution d{"s", 1000, 1, 1e-6, {}};
  for (int k = 1; k <= 1000; ++k) d.masses.push_back(std::pow(k, -1 / alpha));
  for (const SizeStep& step : steps(d))
    EXPECT_NEAR(step.count / std::pow(step.mass, -alpha), 1, 1e-12);
}

TEST(SizesFigure, StatesTheLimitOfEachResolution) {
  SizeDistribution finer = three_remnants();
  finer.name = "paper", finer.limit = 0.001;
  const std::string script = sizes_script({three_remnants(), finer}).text();
  for (const char* text : {"set arrow from 0.05,", "set arrow from 0.001,", "100 particles",
                           "survey: 1,000 particles per target, 2 impacts"})
    EXPECT_THAT(script, testing::HasSubstr(text));
  EXPECT_THROW(sizes_script({{"s", 1000, 3, 0.05, {}}}), InputError);
}

TEST(SizesFigure, IsDrawnInEveryFormat) {
  const test::TemporaryFolder folder;
  draw_sizes(folder / "s.svg", {three_remnants()});
  EXPECT_THAT(read_file(folder / "s.svg"), testing::HasSubstr("remnants per impact"));
  draw_sizes(folder / "s.pdf", {three_remnants()});
  EXPECT_THAT(read_file(folder / "s.pdf"), testing::StartsWith("%PDF"));
}

}  // namespace
}  // namespace eerie::figures
