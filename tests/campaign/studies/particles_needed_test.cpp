#include "campaign/studies/particles_needed.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace eerie::studies {
namespace {
using nlohmann::json;

ConvergenceCell cell(std::int64_t particles, double b_over_a, double m_1) {
  ConvergenceCell c;
  c.scheme = "dual", c.case_name = "A", c.particles_per_target = particles;
  c.b_over_a = statistics::ensemble({b_over_a}), c.m_1 = statistics::ensemble({m_1});
  return c;
}

ConvergenceStudy study_with(const json& published) {
  return parse_convergence_study(
      {{"name", "small"},
       {"schemes", {"dual"}},
       {"cases",
        {{{"name", "A"},
          {"scene", {{"impact", {{"v_imp_cm_per_s", 20}, {"theta_imp_deg", 15}}}}},
          {"published", published}}}},
       {"ladder", {{{"particles_per_target", 300}, {"seeds", 1}}}}},
      "study.json");
}

ParticlesNeeded needed_with(const std::vector<ConvergenceCell>& cells,
                            const json& published = json::object()) {
  return particles_needed(study_with(published), cells).at(0);
}

TEST(ParticlesNeeded, IsTheLeastNumberFromWhichOnEveryMeanIsNearTheFinest) {
  const ParticlesNeeded needed =
      needed_with({cell(1000, 0.30, 0.95), cell(2000, 0.26, 0.95), cell(5000, 0.24, 0.94)});
  EXPECT_EQ(needed.finest, 5000);
  EXPECT_EQ(needed.own, 2000);
}

TEST(ParticlesNeeded, DoesNotCountANumberThatIsRightByChance) {
  const ParticlesNeeded needed =
      needed_with({cell(1000, 0.24, 0.95), cell(2000, 0.30, 0.95), cell(5000, 0.24, 0.95)});
  EXPECT_EQ(needed.own, 5000);
}

TEST(ParticlesNeeded, AsksForTheMassAsWell) {
  const ParticlesNeeded needed = needed_with({cell(1000, 0.24, 0.85), cell(2000, 0.24, 0.95)});
  EXPECT_EQ(needed.own, 2000);
}

TEST(ParticlesNeeded, SaysNothingOfItselfWithOneNumberAlone) {
  const ParticlesNeeded needed = needed_with({cell(1000, 0.24, 0.95)}, {{"b_over_a", 0.25}});
  EXPECT_EQ(needed.own, std::nullopt);
  EXPECT_EQ(needed.published, 1000);
  EXPECT_EQ(needed.b_over_a, std::nullopt);
}

TEST(ParticlesNeeded, OfThePublishedNumberEndsWhereTheFinestMissesIt) {
  const json published = {{"b_over_a", 0.30}, {"m_1_over_m_total", 0.95}};
  EXPECT_EQ(needed_with({cell(1000, 0.30, 0.95), cell(2000, 0.31, 0.93)}, published).published,
            1000);
  const ParticlesNeeded missed =
      needed_with({cell(1000, 0.30, 0.95), cell(2000, 0.25, 0.95)}, published);
  EXPECT_TRUE(missed.has_published);
  EXPECT_EQ(missed.published, std::nullopt);
}

TEST(ParticlesNeeded, OfAPublishedEerAsksForItInMostRuns) {
  std::vector<ConvergenceCell> cells = {cell(1000, 0.4, 0.9), cell(2000, 0.4, 0.9),
                                        cell(5000, 0.4, 0.9)};
  cells[0].p_top3_eer = 0.5, cells[1].p_top3_eer = 0.6, cells[2].p_top3_eer = 1;
  EXPECT_EQ(needed_with(cells, {{"eer", true}}).published, 2000);
  EXPECT_EQ(needed_with(cells, {{"eer", false}}).published, std::nullopt);
  for (ConvergenceCell& c : cells) c.p_top3_eer = 1 - c.p_top3_eer;
  EXPECT_EQ(needed_with(cells, {{"eer", false}}).published, 2000);
  EXPECT_EQ(needed_with(cells, {{"eer", true}, {"b_over_a", 0.4}}).published, std::nullopt);
  EXPECT_FALSE(needed_with(cells).has_published);
}

TEST(ParticlesNeeded, OfPublishedNumbersLooksAtTheTimeWhenTheyWereMeasured) {
  ConvergenceCell met_later = cell(1000, 0.6, 0.9);
  met_later.at_published.b_over_a = statistics::ensemble({0.25});
  met_later.at_published.m_1 = statistics::ensemble({0.5});
  met_later.at_published.p_top3_eer = 1;
  const json published = {{"b_over_a", 0.24}, {"m_1_over_m_total", 0.5}, {"eer", true}};
  EXPECT_EQ(needed_with({met_later}, published).published, 1000);
  EXPECT_EQ(needed_with({met_later}, {{"b_over_a", 0.6}}).published, std::nullopt);
}

TEST(ParticlesNeeded, FindsTheLimitOfALineInTheSpacing) {
  std::vector<ConvergenceCell> cells;
  for (const std::int64_t n : {1000, 2000, 5000, 20000})
    cells.push_back(cell(n, 0.2 + 0.5 / std::cbrt(static_cast<double>(n)), 0.95));
  const ParticlesNeeded needed = needed_with(cells);
  ASSERT_TRUE(needed.b_over_a);
  EXPECT_NEAR(needed.b_over_a->value, 0.2, 1e-12);
  EXPECT_NEAR(needed.b_over_a->error, 0, 1e-7);
}

TEST(ParticlesNeeded, GivesTheErrorThatScatterAboutTheLineMakes) {
  // x = 0.1, 0.05, 0.02: y = 1 + x and -1, 2, -1 times 0.001 or so across the line.
  const std::vector<ConvergenceCell> cells = {
      cell(1000, 1.1 - 0.003, 0.9), cell(8000, 1.05 + 0.008, 0.9), cell(125000, 1.02 - 0.005, 0.9)};
  const ParticlesNeeded needed = needed_with(cells);
  ASSERT_TRUE(needed.b_over_a);
  // The scatter is orthogonal to 1 and to x, so the line is as without it; its square sum is
  // 9.8e-5 with one degree of freedom, and the intercept's factor 1/3 + (0.17/3)^2 / 0.0032666.
  EXPECT_NEAR(needed.b_over_a->value, 1, 1e-12);
  const double factor = 1.0 / 3 + (0.17 / 3) * (0.17 / 3) / (0.0129 - 0.17 * 0.17 / 3);
  EXPECT_NEAR(needed.b_over_a->error, std::sqrt(9.8e-5 * factor), 1e-9);
}

TEST(ParticlesNeeded, WeighsMeansByTheirRunsAndCountsTheScatterOfSeeds) {
  // Three seeds at 1,000 (x = 0.1), one each at 8,000 (0.05) and 125,000 (0.02), on y = 1 + x.
  std::vector<ConvergenceCell> cells = {cell(1000, 0, 0.9), cell(8000, 1.05, 0.9),
                                        cell(125000, 1.02, 0.9)};
  cells[0].b_over_a = statistics::ensemble({1.07, 1.10, 1.13});
  const ParticlesNeeded needed = needed_with(cells);
  ASSERT_TRUE(needed.b_over_a);
  ASSERT_TRUE(needed.known_to);
  EXPECT_NEAR(*needed.known_to, 0.03, 1e-12);
  EXPECT_NEAR(needed.b_over_a->value, 1, 1e-12);
  const double mean_x = (3 * 0.1 + 0.05 + 0.02) / 5;
  const double xx = 3 * 0.01 + 0.0025 + 0.0004 - 5 * mean_x * mean_x;
  EXPECT_NEAR(needed.b_over_a->error, 0.03 * std::sqrt(1.0 / 5 + mean_x * mean_x / xx), 1e-12);
}

TEST(ParticlesNeeded, LeavesFieldsEmptyInItsCsvWhereThereIsNothingToSay) {
  const std::string csv =
      particles_needed_csv(particles_needed(study_with(json::object()), {cell(1000, 0.24, 0.95)}));
  EXPECT_THAT(csv, testing::HasSubstr("A,dual,1000,,,,,\n"));
}

}  // namespace
}  // namespace eerie::studies
