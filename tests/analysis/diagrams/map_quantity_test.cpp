#include "analysis/diagrams/map_quantity.hpp"

#include <gmock/gmock.h>

#include "analysis/remnants/outcome.hpp"
#include "solver/base/error.hpp"

namespace eerie::diagrams {
namespace {
using testing::DoubleNear;
using testing::ElementsAre;

std::vector<PhaseCell> with_periods(std::initializer_list<double> hours) {
  std::vector<PhaseCell> cells;
  for (const double period : hours) {
    PhaseCell cell{20, 15, CellState::done};
    cell.period_h = period;
    cells.push_back(cell);
  }
  return cells;
}

TEST(MapQuantity, IsFoundByItsTokenAndRefusedWithTheTokensThatThereAre) {
  for (const QuantityName& row : quantity_names) EXPECT_EQ(quantity_named(row.token), row.quantity);
  try {
    quantity_named("mass");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "--quantity mass: must be one of b/a, c/a, m-lr, period, class, n-eer, p-eer");
  }
}

TEST(MapQuantity, WordsAreAsShortAsTheNumberAllows) {
  EXPECT_EQ(value_words(MapQuantity::b_over_a, 0.238), "0.24");
  EXPECT_EQ(value_words(MapQuantity::period, 9.36), "9.4");
  EXPECT_EQ(value_words(MapQuantity::period, 9.96), "10");
  EXPECT_EQ(value_words(MapQuantity::period, 123.4), "123");
  EXPECT_EQ(value_words(MapQuantity::p_largest_eer, 1), "1");
  EXPECT_EQ(value_words(MapQuantity::p_largest_eer, 0.25), "0.25");
}

TEST(MapScale, OfAFractionGoesFromNoneToAll) {
  for (const MapQuantity quantity : {MapQuantity::b_over_a, MapQuantity::c_over_a,
                                     MapQuantity::m_lr, MapQuantity::p_largest_eer}) {
    const MapScale scale = map_scale(quantity, {{20, 15, CellState::done, 0.5}});
    EXPECT_EQ(scale.low, 0);
    EXPECT_EQ(scale.high, 1);
  }
}

TEST(MapScale, OfPeriodsGoesFromRoundNumberToRoundNumber) {
  const MapScale narrow = map_scale(MapQuantity::period, with_periods({7.3, 9.9}));
  EXPECT_FALSE(narrow.logarithmic);
  EXPECT_THAT(narrow.ticks, ElementsAre(7, 7.5, 8, 8.5, 9, 9.5, 10));
  const MapScale wide = map_scale(MapQuantity::period, with_periods({7.3, 130}));
  EXPECT_TRUE(wide.logarithmic);
  EXPECT_THAT(wide.ticks,
              ElementsAre(DoubleNear(5, 1e-9), DoubleNear(10, 1e-9), DoubleNear(20, 1e-9),
                          DoubleNear(50, 1e-9), DoubleNear(100, 1e-9), DoubleNear(200, 1e-9)));
  EXPECT_EQ(wide.part(wide.low), 0);
  EXPECT_EQ(wide.part(wide.high), 1);
  EXPECT_NEAR(wide.part(std::sqrt(wide.low * wide.high)), 0.5, 1e-12);
}

TEST(MapScale, OfOnePeriodHasRoomAroundIt) {
  const MapScale scale = map_scale(MapQuantity::period, with_periods({9.36, 9.36}));
  EXPECT_LT(scale.low, 9.36);
  EXPECT_GT(scale.high, 9.36);
  EXPECT_GE(scale.ticks.size(), 2u);
}

TEST(MapScale, LeavesOutWhatHasNoResult) {
  std::vector<PhaseCell> cells = with_periods({8, 9, 1000});
  cells.back().state = CellState::pending;
  EXPECT_LE(map_scale(MapQuantity::period, cells).high, 10);
}

TEST(MapScale, OfEersGrowsDarkerAndOthersGrowLighter) {
  for (const MapQuantity quantity : {MapQuantity::p_largest_eer, MapQuantity::m_lr}) {
    const MapScale scale{quantity};
    for (double part = 0; part < 0.95; part += 0.05) {
      const double change =
          drawing::lightness(scale.at_part(part + 0.05)) - drawing::lightness(scale.at_part(part));
      EXPECT_GT(quantity == MapQuantity::p_largest_eer ? -change : change, 0) << part;
    }
  }
}

TEST(OutcomeColours, AreAllDifferent) {
  for (const remnants::OutcomeName& a : remnants::outcome_names)
    for (const remnants::OutcomeName& b : remnants::outcome_names)
      EXPECT_EQ(outcome_colour(a.name) == outcome_colour(b.name), a.outcome == b.outcome);
}

}  // namespace
}  // namespace eerie::diagrams
