#include "campaign/auto_fidelity/certainty.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/statistics/student.hpp"

namespace eerie::auto_fidelity {
namespace {

std::vector<Sample> samples(const std::vector<double>& b_over_a,
                            const std::string& outcome = "perfect-merging") {
  std::vector<Sample> all;
  for (const double value : b_over_a) all.push_back({outcome, value, 1});
  return all;
}

TEST(Doubt, CountsClassesByJeffreysRule) {
  std::vector<Sample> some = samples({0.5, 0.5, 0.5});
  EXPECT_DOUBLE_EQ(answer_of(some, 0.03, {}).p_outcome, 3.5 / 4);
  some.push_back({"hit-and-run", 0.5, 1});
  EXPECT_EQ(answer_of(some, 0.03, {}).outcome, "perfect-merging");
  EXPECT_DOUBLE_EQ(answer_of(some, 0.03, {}).p_outcome, 3.5 / 5);
}

TEST(Doubt, NeedsFourAlikeForNineInTen) {
  EXPECT_TRUE(answer_of(samples({0.5, 0.5, 0.5}), 0.03, {}).in_doubt(0.9));
  EXPECT_FALSE(answer_of(samples({0.5, 0.5, 0.5, 0.5}), 0.03, {}).in_doubt(0.9));
}

TEST(Doubt, KnowsWhenMoreRunsCannotHelp) {
  std::vector<Sample> some = samples({0.5, 0.5, 0.5});
  EXPECT_DOUBLE_EQ(best_p_outcome(some, 8), 8.5 / 9);
  some.push_back({"hit-and-run", 0.5, 1});
  EXPECT_DOUBLE_EQ(best_p_outcome(some, 8), 7.5 / 9);
  EXPECT_DOUBLE_EQ(best_p_outcome(some, 4), answer_of(some, 0.03, {}).p_outcome);
}

TEST(Doubt, IsLessAmongNeighboursOfTheSameClass) {
  const std::vector<Sample> two = samples({0.5, 0.5});
  EXPECT_DOUBLE_EQ(answer_of(two, 0.03, {}, {{"perfect-merging", 1}}).p_outcome, 4.5 / 5);
  EXPECT_DOUBLE_EQ(answer_of(two, 0.03, {}, {{"perfect-merging", 0.5}}).p_outcome, 3.5 / 4);
  // A border runs between neighbours of different classes: that says nothing.
  EXPECT_DOUBLE_EQ(answer_of(two, 0.03, {}, {{"hit-and-run", 1}}).p_outcome, 2.5 / 3);
  EXPECT_DOUBLE_EQ(best_p_outcome(two, 8, {{"perfect-merging", 1}}), 10.5 / 11);
}

TEST(Doubt, KnowsWhereOnAverageMoreRunsWouldNotTellTheSideOfThreeTenths) {
  // Straddling 0.3, and clear of it though two runs alone leave it in doubt.
  EXPECT_LT(best_p_side(samples({0.28, 0.33, 0.27, 0.31}), 0.03, 8), 0.8);
  const std::vector<Sample> clear = samples({0.33, 0.35});
  EXPECT_TRUE(answer_of(clear, 0.03, {}).in_doubt(0.9));
  EXPECT_GT(best_p_side(clear, 0.03, 8), 0.95);
  EXPECT_EQ(best_p_side(std::vector<Sample>{{"catastrophic-disruption", std::nullopt, 1}}, 0.03, 8),
            1);
}

TEST(Doubt, CountsTheClassesOfRuns) {
  std::vector<Sample> some = samples({0.5, 0.5, 0.5});
  some.push_back({"hit-and-run", 0.5, 1});
  EXPECT_EQ(leading_class(some), "perfect-merging");
  EXPECT_EQ(class_shares(some), (ClassShares{{"hit-and-run", 0.25}, {"perfect-merging", 0.75}}));
}

TEST(Doubt, AsksWhetherOneMoreRunWouldBeElongatedByStudentsPrediction) {
  // One run at 0.25 with a known spread of 0.05 as four runs' worth of knowledge.
  const Answer one = answer_of(samples({0.25}), 0.05, {});
  EXPECT_NEAR(one.p_elongated, statistics::student_cdf(0.05 / (0.05 * std::sqrt(2)), 4), 1e-12);
  // Many runs: their own mean and spread decide.
  std::vector<double> many;
  for (int k = 0; k < 400; ++k) many.push_back(0.3 + 0.02 * (k % 2 == 0 ? 1 : -1) - 0.02);
  const Answer sure = answer_of(samples(many), 0.5, {});
  EXPECT_NEAR(sure.p_elongated, statistics::student_cdf(1 / std::sqrt(1 + 4 * 625.0 / 403), 403),
              0.02);
  EXPECT_NEAR(sure.b_over_a, 0.28, 1e-12);
}

TEST(Doubt, GrowsWithWhatACoarseRunMayBeOffBy) {
  const std::vector<Sample> some = samples({0.36, 0.36, 0.36, 0.36});
  const double sure = answer_of(some, 0.02, {}).p_elongated;
  const double widened = answer_of(some, 0.02, {0, 0.05}).p_elongated;
  const double shifted = answer_of(some, 0.02, {-0.06, 0}).p_elongated;
  EXPECT_LT(sure, 0.03);
  EXPECT_GT(widened, 3 * sure);
  EXPECT_NEAR(shifted, 0.5, 1e-9);
}

TEST(Doubt, CallsAnImpactWithoutARemnantNotElongated) {
  std::vector<Sample> none = {{"catastrophic-disruption", std::nullopt, 1},
                              {"catastrophic-disruption", std::nullopt, 1}};
  EXPECT_EQ(answer_of(none, 0.03, {}).p_elongated, 0);
  none.push_back({"catastrophic-disruption", 0.2, 1});
  EXPECT_LT(answer_of(none, 0.03, {}).p_elongated, 1.0 / 3);
}

TEST(Doubt, TakesTheTypicalSpreadOfEnsemblesThatAgreeOnTheirClass) {
  EXPECT_DOUBLE_EQ(typical_deviation({}, 0.03), 0.03);
  // Two runs 0.02 apart: 0.01 sqrt(2), of which a sample of two shows 0.68 in the median.
  const double expected = 0.02 / std::sqrt(2) / std::pow(7.0 / 9, 1.5);
  std::vector<std::vector<Sample>> ensembles(9, samples({0.3, 0.32}));
  EXPECT_NEAR(typical_deviation(ensembles, 0.03), expected, 1e-12);
  // A few that scatter widely do not change what is typical, nor do impacts of two kinds.
  for (int k = 0; k < 3; ++k) ensembles.push_back(samples({0.3, 0.9}));
  for (int k = 0; k < 20; ++k) {
    ensembles.push_back(samples({0.2, 0.9}));
    ensembles.back()[1].outcome = "hit-and-run";
  }
  EXPECT_NEAR(typical_deviation(ensembles, 0.03), expected, 1e-12);
}

TEST(Doubt, LearnsHowCoarseStandsToFineFromWhatHasBoth) {
  EXPECT_DOUBLE_EQ(transfer_between({}, 0.05).scatter, 0.05);
  std::vector<Both> impacts(96, {samples({0.35}), samples({0.30})});
  const Transfer known = transfer_between(impacts, 0.05);
  EXPECT_NEAR(known.shift, -0.05 * 96 / 100, 1e-12);
  EXPECT_LT(known.scatter, 0.02);
  EXPECT_EQ(transfer_between(std::vector<Both>{{samples({0.3}), {}}}, 0.05).shift, 0);
}

}  // namespace
}  // namespace eerie::auto_fidelity
