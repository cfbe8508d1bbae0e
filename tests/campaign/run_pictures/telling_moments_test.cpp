#include "campaign/run_pictures/telling_moments.hpp"

#include <gmock/gmock.h>

namespace eerie::run_pictures {
namespace {

using Named = std::pair<std::size_t, std::string>;

std::vector<Named> named(const std::vector<Moment>& course) {
  std::vector<Named> all;
  for (const TellingMoment& m : telling_moments(course)) all.emplace_back(m.snapshot, m.name);
  return all;
}

TEST(TellingMoments, AreContactLongestSeparationFallBackAndEnd) {
  // Two bodies meet, stretch, part, meet again.
  const std::vector<Moment> course = {{0, 2, 100},    {500, 2, 100},  {1000, 1, 200},
                                      {1500, 1, 260}, {2000, 1, 300}, {2500, 1, 280},
                                      {3000, 2, 150}, {3500, 3, 140}, {4000, 3, 140},
                                      {4500, 2, 160}, {5000, 1, 250}, {5500, 1, 240}};
  EXPECT_THAT(named(course), testing::ElementsAre(Named{2, "contact"}, Named{4, "longest"},
                                                  Named{6, "first separation"},
                                                  Named{9, "fall-back"}, Named{11, "end"}));
}

TEST(TellingMoments, OfABodyThatBreaksAtItsLongestShowItHalfWay) {
  const std::vector<Moment> course = {{0, 2, 100},    {500, 1, 200},  {1000, 1, 250},
                                      {3000, 1, 300}, {5000, 1, 400}, {5500, 1, 450},
                                      {6000, 2, 300}, {9000, 2, 300}};
  EXPECT_THAT(named(course),
              testing::ElementsAre(Named{0, "start"}, Named{1, "contact"}, Named{3, "stretching"},
                                   Named{6, "first separation"}, Named{7, "end"}));
}

TEST(TellingMoments, OfAMergerFillUpWithTheStartAndTheWidestGap) {
  const std::vector<Moment> course = {{0, 2, 100},    {500, 1, 190},  {1000, 1, 300},
                                      {1500, 1, 280}, {5000, 1, 270}, {9500, 1, 270},
                                      {10000, 1, 270}};
  EXPECT_THAT(named(course),
              testing::ElementsAre(Named{0, "start"}, Named{1, "contact"}, Named{2, "longest"},
                                   Named{4, ""}, Named{6, "end"}));
}

TEST(TellingMoments, NeverTakeASnapshotTwice) {
  EXPECT_THAT(named({{0, 2, 100}, {30000, 1, 300}}),
              testing::ElementsAre(Named{0, "start"}, Named{1, "end"}));
  EXPECT_THAT(named({{0, 1, 100}}), testing::ElementsAre(Named{0, "end"}));
  EXPECT_TRUE(named({}).empty());
}

TEST(TellingMoments, OfBodiesThatNeverTouchAreSpreadOverTime) {
  std::vector<Moment> course;
  for (int k = 0; k <= 100; ++k) course.push_back({500.0 * k, 2, 100});
  const std::vector<Named> all = named(course);
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(all.front().first, 0u);
  EXPECT_EQ(all[2].first, 50u);
  EXPECT_EQ(all.back().first, 100u);
}

}  // namespace
}  // namespace eerie::run_pictures
