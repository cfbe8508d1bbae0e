#include "analysis/diagrams/phase_words.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/diagrams/phase_cells.hpp"
#include "solver/base/constants.hpp"

namespace eerie::diagrams {
namespace {

constexpr PanelFrame frame{10, 30, 5, 35, {{0, 0}, {200, 150}}};

TEST(CurveCrosses, ExactlyTheCellsThatThePointsOfTheCurveLieIn) {
  constexpr double constant = 5.1;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 15; ++j) {
      const drawing::Area cell{{10.0 * i, 10.0 * j}, {10.0 * i + 10, 10.0 * j + 10}};
      bool inside = false;
      for (double v = 10; v <= 30; v += 0.001) {
        const double x = frame.x(v), y = frame.y(degrees(std::asin(constant / v)));
        inside = inside || (x > cell.low.x && x < cell.high.x && y > cell.low.y && y < cell.high.y);
      }
      EXPECT_EQ(curve_crosses(cell, frame, constant), inside) << i << " " << j;
    }
}

TEST(PlacesOfWords, KeepAwayFromTheCurveWhereverACellHasRoom) {
  constexpr double constant = 5.1;
  const std::vector<CellLine> lines = {{"0.24", 6}, {"M", 5.5, true}};
  int crossed = 0;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 6; ++j) {
      const drawing::Area cell{{25.0 * i, 25.0 * j}, {25.0 * i + 25, 25.0 * j + 25}};
      const auto places = places_of_words(cell, lines, frame, constant);
      ASSERT_EQ(places.size(), 2u);
      crossed += curve_crosses(cell, frame, constant);
      for (std::size_t k = 0; k < 2; ++k) {
        const double w = lines[k].width() / 2, h = lines[k].height() / 2;
        const drawing::Area box{{places[k].x - w, places[k].y - h},
                                {places[k].x + w, places[k].y + h}};
        EXPECT_FALSE(curve_crosses(box, frame, constant)) << i << " " << j << " line " << k;
        EXPECT_GE(box.low.x, cell.low.x);
        EXPECT_LE(box.high.x, cell.high.x);
        EXPECT_GE(box.low.y, cell.low.y);
        EXPECT_LE(box.high.y, cell.high.y);
      }
      EXPECT_GE(std::abs(places[0].y - places[1].y),
                (lines[0].height() + lines[1].height()) / 2 - 1e-9);
    }
  EXPECT_GT(crossed, 5);
}

TEST(NumberWords, HaveOneFormatInAPanel) {
  EXPECT_EQ(number_words(MapQuantity::b_over_a, 0.24, false), "0.24");
  EXPECT_EQ(number_words(MapQuantity::b_over_a, 0.24, true), ".24");
  EXPECT_EQ(number_words(MapQuantity::b_over_a, 1, true), "1.0");
}

}  // namespace
}  // namespace eerie::diagrams
