#include "solver/step/chebyshev_stages.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace eerie::step {
namespace {

/// What a step of these stages leaves of y where y' = -z y/dt.
double left(const ChebyshevStages& stages, double z) {
  double before = 0, change = -stages.first() * z;
  for (int j = 2; j <= stages.count(); ++j) {
    const auto weight = stages.weights(j);
    const double next =
        weight.last * change + weight.before * before - weight.step * z * (1 + change);
    before = change, change = next;
  }
  return 1 + change;
}

TEST(ChebyshevStages, OfOneAreEulersStep) {
  const ChebyshevStages one(1);
  EXPECT_EQ(one.reach(), 1);
  for (const double z : {0.1, 1.0, 3.0}) EXPECT_DOUBLE_EQ(left(one, z), 1 - z);
}

TEST(ChebyshevStages, DampWhatIsWithinTheirReachAndNothingWellBeyond) {
  for (int count = 1; count <= 8; ++count) {
    const ChebyshevStages stages(count);
    const double fastest = 2 * stages.reach();
    for (double z = 0.02; z < fastest; z += 0.02) EXPECT_LT(std::abs(left(stages, z)), 1) << z;
    EXPECT_GT(std::abs(left(stages, 1.2 * fastest)), 1) << count;
    // Twice the stages, about four times the reach.
    const double per_square = stages.reach() / (count * count);
    EXPECT_NEAR(per_square, count == 1 ? 1 : 0.57, 0.03) << count;
  }
}

TEST(ChebyshevStages, LeaveLittleOfTheFastest) {
  for (int count = 2; count <= 8; ++count) {
    const ChebyshevStages stages(count);
    for (double z = 1.5; z < 1.99 * stages.reach(); z += 0.01)
      EXPECT_LT(std::abs(left(stages, z)), 0.37) << count << " stages, " << z;
  }
}

/// y' = -z y/dt + g with a slow force: all of it counts, and slow decay is that of first order.
TEST(ChebyshevStages, AreOfFirstOrder) {
  for (int count = 1; count <= 8; ++count) {
    const ChebyshevStages stages(count);
    EXPECT_NEAR((left(stages, 1e-5) - 1) / -1e-5, 1, 1e-5) << count;
    const auto error = [&](double z) { return std::abs(left(stages, z) - std::exp(-z)); };
    EXPECT_NEAR(error(0.02) / error(0.01), 4, 0.1) << count;  // of one step: one order more
  }
}

}  // namespace
}  // namespace eerie::step
