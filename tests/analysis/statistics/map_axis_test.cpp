#include "analysis/statistics/map_axis.hpp"

#include <gmock/gmock.h>

namespace eerie::statistics {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

TEST(MapAxis, CellsReachHalfWayToTheirNeighbours) {
  const MapAxis axis = map_axis({24, 15, 22, 18, 20, 15, 18});
  EXPECT_THAT(axis.at, ElementsAre(15, 18, 20, 22, 24));
  EXPECT_THAT(axis.edges, ElementsAre(13.5, 16.5, 19, 21, 23, 25));
}

TEST(MapAxis, EveryPlaceLiesBetweenItsEdges) {
  const MapAxis axis = map_axis({1, 2, 4, 8, 16});
  for (const double value : axis.at) {
    EXPECT_LT(axis.edges[axis.index(value)], value);
    EXPECT_GT(axis.edges[axis.index(value) + 1], value);
  }
}

TEST(MapAxis, SingleValueGetsACellOfItsOwn) {
  EXPECT_THAT(map_axis({15}).edges, ElementsAre(14.5, 15.5));
}

TEST(RoundTicks, AreRoundAndFew) {
  EXPECT_THAT(round_ticks(2.2, 4.1, 8), ElementsAre(2.5, 3, 3.5, 4));
  EXPECT_THAT(round_ticks(2.2, 4.1, 20),
              testing::AllOf(testing::SizeIs(19), testing::Contains(DoubleEq(3.1))));
  EXPECT_THAT(round_ticks(0, 100, 5), ElementsAre(0, 50, 100));
  EXPECT_THAT(round_ticks(0, 99, 5), ElementsAre(0, 20, 40, 60, 80));
}

}  // namespace
}  // namespace eerie::statistics
