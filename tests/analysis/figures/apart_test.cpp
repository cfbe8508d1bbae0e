#include "analysis/figures/apart.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "analysis/figures/value_axis.hpp"

namespace eerie::figures {
namespace {

TEST(ShiftsApart, LeaveNoMarkOnAnotherAndMoveOnlyWhatMust) {
  const std::vector<drawing::Point> marks = {{10, 10}, {10, 10}, {10.5, 10}, {10, 30}, {10, 12}};
  const std::vector<double> shifts = shifts_apart(marks, 4, 50);
  EXPECT_EQ(shifts[0], 0);
  EXPECT_EQ(shifts[3], 0);
  for (std::size_t a = 0; a < marks.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_GE(
          std::hypot(marks[a].x + shifts[a] - marks[b].x - shifts[b], marks[a].y - marks[b].y), 4)
          << a << " " << b;
}

TEST(ShiftsApart, StayWhereNothingIsFree) {
  const std::vector<drawing::Point> marks(3, {10, 10});
  EXPECT_THAT(shifts_apart(marks, 4, 1), testing::ElementsAre(0, 0, 0));
}

TEST(ValueAxis, HasRoundTicksOfOneFormat) {
  EXPECT_EQ(value_axis(0.34, 0.81).text(),
            "set yrange [0.34:0.81]\nset ytics 0.1\nset format y '%.1f'\n");
  EXPECT_EQ(value_axis(0, 14).text(), "set yrange [0:14]\nset ytics 2\nset format y '%.0f'\n");
}

}  // namespace
}  // namespace eerie::figures
