#include "analysis/statistics/isolines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "solver/base/constants.hpp"

namespace eerie::statistics {
namespace {

std::vector<double> even(double low, double high, std::size_t count) {
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k)
    values.push_back(low + (high - low) * static_cast<double>(k) / static_cast<double>(count - 1));
  return values;
}

std::vector<Isoline> lines_of(const std::function<double(double, double)>& f, std::size_t count,
                              double level) {
  const auto axis = even(-2, 2, count);
  std::vector<double> values;
  for (const double y : axis)
    for (const double x : axis) values.push_back(f(x, y));
  return isolines(axis, axis, values, level);
}

double length_of(const Isoline& line) {
  double sum = 0;
  for (std::size_t k = 1; k < line.size(); ++k)
    sum += std::hypot(line[k][0] - line[k - 1][0], line[k][1] - line[k - 1][1]);
  return sum;
}

TEST(Isolines, ACircleIsOneClosedCurveOfItsLength) {
  const auto lines = lines_of([](double x, double y) { return x * x + y * y; }, 101, 1.3 * 1.3);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].front(), lines[0].back());
  // Chords of cells of 0.04: the error is of the order of 0.04^2/8.
  for (const auto& [x, y] : lines[0]) EXPECT_NEAR(std::hypot(x, y), 1.3, 4e-4);
  EXPECT_NEAR(length_of(lines[0]), 2 * pi * 1.3, 5e-3);
}

TEST(Isolines, ALineThatLeavesTheMapIsOpenAndReachesItsEdges) {
  const auto lines = lines_of([](double x, double y) { return x + 0.25 * y; }, 20, 0.1);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(std::abs(lines[0].front()[1]), 2, 1e-12);
  EXPECT_NEAR(lines[0].front()[1], -lines[0].back()[1], 1e-12);
  for (const auto& [x, y] : lines[0]) EXPECT_NEAR(x + 0.25 * y, 0.1, 1e-12);
}

TEST(Isolines, ASaddleIsPartedByItsMiddle) {
  // One cell with high corners 0 and 2: joined where the middle is high, apart where it is low.
  const std::vector<double> unit = {0, 1};
  for (const bool high : {true, false}) {
    const double top = high ? 3 : 1.5;
    const auto lines = isolines(unit, unit, {top, 0, 0, top}, 1);
    ASSERT_EQ(lines.size(), 2u);
    for (const Isoline& line : lines) {
      // A curve cuts off one corner: its middle is nearer to that one than to any other.
      const double x = (line[0][0] + line[1][0]) / 2, y = (line[0][1] + line[1][1]) / 2;
      EXPECT_EQ((x < 0.5) == (y < 0.5), !high) << x << " " << y;
    }
  }
}

TEST(Isolines, TwoHillsHaveTwoCurvesAndAPlainHasNone) {
  const auto hills = [](double x, double y) {
    return std::exp(-8 * ((x - 1) * (x - 1) + y * y)) + std::exp(-8 * ((x + 1) * (x + 1) + y * y));
  };
  EXPECT_EQ(lines_of(hills, 60, 0.5).size(), 2u);
  EXPECT_TRUE(lines_of([](double, double) { return 0.2; }, 20, 0.5).empty());
}

TEST(Isolines, AnotherNumberOfValuesIsRefused) {
  EXPECT_THROW(isolines({0, 1}, {0, 1}, {1, 2, 3}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace eerie::statistics
