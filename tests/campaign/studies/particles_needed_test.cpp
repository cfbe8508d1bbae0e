#include "campaign/studies/particles_needed.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace eerie::studies {
namespace {
using nlohmann::json;

StudyCell cell(std::int64_t particles, double b_over_a, double m_1) {
  StudyCell c;
  c.scheme = "dual", c.case_name = "A", c.particles_per_target = particles;
  c.b_over_a = statistics::ensemble({b_over_a}), c.m_1 = statistics::ensemble({m_1});
  return c;
}

Study study_with(const json& published) {
  return parse_study({{"name", "small"},
                      {"schemes", {"dual"}},
                      {"cases",
                       {{{"name", "A"},
                         {"scene", {{"impact", {{"v_imp_cm_per_s", 20}, {"theta_imp_deg", 15}}}}},
                         {"published", published}}}},
                      {"ladder", {{{"particles_per_target", 300}, {"seeds", 1}}}}},
                     "study.json");
}

Reach reach_of(const std::vector<StudyCell>& cells, const json& published = json::object()) {
  return reaches_of(study_with(published), cells).at(0);
}

TEST(Reach, IsTheLeastNumberFromWhichOnEveryMeanIsNearTheFinest) {
  const Reach reach =
      reach_of({cell(1000, 0.30, 0.95), cell(2000, 0.26, 0.95), cell(5000, 0.24, 0.94)});
  EXPECT_EQ(reach.finest, 5000);
  EXPECT_EQ(reach.own, 2000);
}

TEST(Reach, DoesNotCountANumberThatIsRightByChance) {
  const Reach reach =
      reach_of({cell(1000, 0.24, 0.95), cell(2000, 0.30, 0.95), cell(5000, 0.24, 0.95)});
  EXPECT_EQ(reach.own, 5000);
}

TEST(Reach, AsksForTheMassAsWell) {
  const Reach reach = reach_of({cell(1000, 0.24, 0.85), cell(2000, 0.24, 0.95)});
  EXPECT_EQ(reach.own, 2000);
}

TEST(Reach, SaysNothingOfItselfWithOneNumberAlone) {
  const Reach reach = reach_of({cell(1000, 0.24, 0.95)}, {{"b_over_a", 0.25}});
  EXPECT_EQ(reach.own, std::nullopt);
  EXPECT_EQ(reach.published, 1000);
  EXPECT_EQ(reach.b_over_a, std::nullopt);
}

TEST(Reach, OfThePublishedNumberEndsWhereTheFinestMissesIt) {
  const json published = {{"b_over_a", 0.30}, {"m_1_over_m_total", 0.95}};
  EXPECT_EQ(reach_of({cell(1000, 0.30, 0.95), cell(2000, 0.31, 0.93)}, published).published, 1000);
  const Reach missed = reach_of({cell(1000, 0.30, 0.95), cell(2000, 0.25, 0.95)}, published);
  EXPECT_TRUE(missed.has_published);
  EXPECT_EQ(missed.published, std::nullopt);
}

TEST(Reach, OfAPublishedEerAsksForItInMostRuns) {
  std::vector<StudyCell> cells = {cell(1000, 0.4, 0.9), cell(2000, 0.4, 0.9), cell(5000, 0.4, 0.9)};
  cells[0].p_top3_eer = 0.5, cells[1].p_top3_eer = 0.6, cells[2].p_top3_eer = 1;
  EXPECT_EQ(reach_of(cells, {{"eer", true}}).published, 2000);
  EXPECT_EQ(reach_of(cells, {{"eer", false}}).published, std::nullopt);
  for (StudyCell& c : cells) c.p_top3_eer = 1 - c.p_top3_eer;
  EXPECT_EQ(reach_of(cells, {{"eer", false}}).published, 2000);
  EXPECT_EQ(reach_of(cells, {{"eer", true}, {"b_over_a", 0.4}}).published, std::nullopt);
  EXPECT_FALSE(reach_of(cells).has_published);
}

TEST(Reach, OfPublishedNumbersLooksAtTheTimeWhenTheyWereMeasured) {
  StudyCell met_later = cell(1000, 0.6, 0.9);
  met_later.at_published.b_over_a = statistics::ensemble({0.25});
  met_later.at_published.m_1 = statistics::ensemble({0.5});
  met_later.at_published.p_top3_eer = 1;
  const json published = {{"b_over_a", 0.24}, {"m_1_over_m_total", 0.5}, {"eer", true}};
  EXPECT_EQ(reach_of({met_later}, published).published, 1000);
  EXPECT_EQ(reach_of({met_later}, {{"b_over_a", 0.6}}).published, std::nullopt);
}

TEST(Reach, FindsTheLimitOfALineInTheSpacing) {
  std::vector<StudyCell> cells;
  for (const std::int64_t n : {1000, 2000, 5000, 20000})
    cells.push_back(cell(n, 0.2 + 0.5 / std::cbrt(static_cast<double>(n)), 0.95));
  const Reach reach = reach_of(cells);
  ASSERT_TRUE(reach.b_over_a);
  EXPECT_NEAR(reach.b_over_a->value, 0.2, 1e-12);
  EXPECT_NEAR(reach.b_over_a->error, 0, 1e-7);
}

TEST(Reach, GivesTheErrorThatScatterAboutTheLineMakes) {
  // x = 0.1, 0.05, 0.02: y = 1 + x and -1, 2, -1 times 0.001 or so across the line.
  const std::vector<StudyCell> cells = {cell(1000, 1.1 - 0.003, 0.9), cell(8000, 1.05 + 0.008, 0.9),
                                        cell(125000, 1.02 - 0.005, 0.9)};
  const Reach reach = reach_of(cells);
  ASSERT_TRUE(reach.b_over_a);
  // The scatter is orthogonal to 1 and to x, so the line is as without it; its square sum is
  // 9.8e-5 with one degree of freedom, and the intercept's factor 1/3 + (0.17/3)^2 / 0.0032666.
  EXPECT_NEAR(reach.b_over_a->value, 1, 1e-12);
  const double factor = 1.0 / 3 + (0.17 / 3) * (0.17 / 3) / (0.0129 - 0.17 * 0.17 / 3);
  EXPECT_NEAR(reach.b_over_a->error, std::sqrt(9.8e-5 * factor), 1e-9);
}

TEST(Reach, WeighsMeansByTheirRunsAndCountsTheScatterOfSeeds) {
  // Three seeds at 1,000 (x = 0.1), one each at 8,000 (0.05) and 125,000 (0.02), on y = 1 + x.
  std::vector<StudyCell> cells = {cell(1000, 0, 0.9), cell(8000, 1.05, 0.9),
                                  cell(125000, 1.02, 0.9)};
  cells[0].b_over_a = statistics::ensemble({1.07, 1.10, 1.13});
  const Reach reach = reach_of(cells);
  ASSERT_TRUE(reach.b_over_a);
  ASSERT_TRUE(reach.known_to);
  EXPECT_NEAR(*reach.known_to, 0.03, 1e-12);
  EXPECT_NEAR(reach.b_over_a->value, 1, 1e-12);
  const double mean_x = (3 * 0.1 + 0.05 + 0.02) / 5;
  const double xx = 3 * 0.01 + 0.0025 + 0.0004 - 5 * mean_x * mean_x;
  EXPECT_NEAR(reach.b_over_a->error, 0.03 * std::sqrt(1.0 / 5 + mean_x * mean_x / xx), 1e-12);
}

TEST(Reach, LeavesFieldsEmptyInItsCsvWhereThereIsNothingToSay) {
  const std::string csv =
      reaches_csv(reaches_of(study_with(json::object()), {cell(1000, 0.24, 0.95)}));
  EXPECT_THAT(csv, testing::HasSubstr("A,dual,1000,,,,,\n"));
}

}  // namespace
}  // namespace eerie::studies
