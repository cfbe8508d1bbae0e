#include "analysis/remnants/outcome.hpp"

#include <gtest/gtest.h>

namespace eerie::remnants {
namespace {

/// Class by masses in units of the target's; q the impactor's.
OutcomeClass classed(double q, double m_lr, double m_slr, bool separated = false) {
  return classify({1, q, m_lr, m_slr}, separated);
}

TEST(Outcome, AlmostAllTheMassIsPerfectMerging) {
  EXPECT_EQ(classed(1, 1.81, 0.1), OutcomeClass::perfect_merging);
  EXPECT_EQ(classed(0.25, 1.25, 0), OutcomeClass::perfect_merging);
}

TEST(Outcome, TwoLargeGroupsAreHitAndRun) {
  EXPECT_EQ(classed(1, 0.98, 0.97), OutcomeClass::hit_and_run);
  EXPECT_EQ(classed(0.5, 1.05, 0.4), OutcomeClass::hit_and_run);
  EXPECT_EQ(classed(1, 1.1, 0.6), OutcomeClass::hit_and_run);  // some mass changed hands
}

TEST(Outcome, TwoLargeGroupsInMuchDebrisAreNoHitAndRun) {
  EXPECT_EQ(classed(1, 0.9, 0.6), OutcomeClass::catastrophic_disruption);
}

TEST(Outcome, LessThanHalfInTheLargestIsCatastrophic) {
  EXPECT_EQ(classed(1, 0.74, 0.6), OutcomeClass::catastrophic_disruption);
  EXPECT_EQ(classed(0.25, 0.6, 0.1), OutcomeClass::catastrophic_disruption);
}

TEST(Outcome, MoreThanTheTargetIsPartialAccretion) {
  EXPECT_EQ(classed(0.5, 1.1, 0.1), OutcomeClass::partial_accretion);  // 1.1 M_t: fact of q 0.5
}

TEST(Outcome, LessThanTheTargetIsErosion) {
  EXPECT_EQ(classed(0.25, 0.9, 0.05), OutcomeClass::erosion);
}

TEST(Outcome, SeparationTurnsMergersIntoGrazeAndMergeAndNothingElse) {
  EXPECT_EQ(classed(1, 1.9, 0.01, true), OutcomeClass::graze_and_merge);
  EXPECT_EQ(classed(0.5, 1.1, 0.1, true), OutcomeClass::graze_and_merge);
  EXPECT_EQ(classed(1, 0.98, 0.97, true), OutcomeClass::hit_and_run);
  EXPECT_EQ(classed(0.25, 0.9, 0.05, true), OutcomeClass::erosion);
  EXPECT_EQ(classed(1, 0.5, 0.1, true), OutcomeClass::catastrophic_disruption);
}

TEST(Outcome, ThresholdsBelongToTheClassTheyName) {
  EXPECT_EQ(classed(1, 1.8, 0), OutcomeClass::perfect_merging);
  EXPECT_NE(classed(1, 1.7999, 0), OutcomeClass::perfect_merging);
  EXPECT_EQ(classed(1, 1.1, 0.5), OutcomeClass::hit_and_run);
  EXPECT_NE(classed(1, 1.1, 0.4999), OutcomeClass::hit_and_run);
  EXPECT_EQ(classed(0.25, 0.625, 0), OutcomeClass::erosion);  // half of 1.25
  EXPECT_EQ(classed(0.25, 0.6249, 0), OutcomeClass::catastrophic_disruption);
  EXPECT_EQ(classed(0.25, 1, 0), OutcomeClass::erosion);  // nothing was accreted
}

TEST(Outcome, NamesComeBack) {
  for (const OutcomeName& row : outcome_names) {
    EXPECT_EQ(name(row.outcome), row.name);
    EXPECT_EQ(outcome_named(row.name), row.outcome);
  }
  EXPECT_EQ(outcome_named("merger"), std::nullopt);
}

}  // namespace
}  // namespace eerie::remnants
