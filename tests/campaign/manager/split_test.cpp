#include "campaign/manager/split.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "tests/support/scenes.hpp"

namespace eerie::manager {
namespace {

using testing::ElementsAre;
using testing::Pair;

std::vector<std::pair<std::size_t, int>> shapes(const std::vector<Split>& splits) {
  std::vector<std::pair<std::size_t, int>> out;
  for (const Split& s : splits) out.emplace_back(s.jobs, s.threads);
  return out;
}

TEST(Splits, RunFromNarrowJobsToOneWideOne) {
  EXPECT_THAT(shapes(possible_splits(8, 100)),
              ElementsAre(Pair(8u, 1), Pair(4u, 2), Pair(2u, 4), Pair(1u, 8)));
  EXPECT_THAT(shapes(possible_splits(1, 100)), ElementsAre(Pair(1u, 1)));
  EXPECT_THAT(shapes(possible_splits(6, 100)), ElementsAre(Pair(6u, 1), Pair(3u, 2), Pair(1u, 6)));
}

TEST(Splits, LeaveNoCoresIdleWhereFewJobsArePending) {
  EXPECT_THAT(shapes(possible_splits(8, 1)), ElementsAre(Pair(1u, 8)));
  EXPECT_THAT(shapes(possible_splits(8, 3)), ElementsAre(Pair(3u, 2), Pair(2u, 4), Pair(1u, 8)));
  EXPECT_THAT(shapes(possible_splits(2, 0)), ElementsAre(Pair(1u, 2)));
}

TEST(Splits, AreMeasuredWithAllTheirJobsAtWorkAndSorted) {
  const Scene scene = test::small_scene();
  const auto splits = measured(possible_splits(2, 5), scene, std::chrono::milliseconds(20));
  ASSERT_EQ(splits.size(), 2u);
  EXPECT_GT(splits[1].particle_steps_per_s, 0);
  EXPECT_GE(splits[0].particle_steps_per_s, splits[1].particle_steps_per_s);
}

}  // namespace
}  // namespace eerie::manager
