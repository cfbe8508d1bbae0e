#include "campaign/sweeps/axis.hpp"

#include <gmock/gmock.h>

#include "solver/base/error.hpp"

namespace eerie::sweeps {
namespace {

TEST(InclusiveRange, HoldsTheDoublesThatAPersonWouldWrite) {
  EXPECT_THAT(inclusive_range(0.1, 0.7, 0.1, "x"),
              testing::ElementsAre(0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7));
  EXPECT_THAT(inclusive_range(7.5, 20, 2.5, "x"),
              testing::ElementsAre(7.5, 10, 12.5, 15, 17.5, 20));
  EXPECT_THAT(inclusive_range(1e-5, 3e-5, 1e-5, "x"), testing::ElementsAre(1e-5, 2e-5, 3e-5));
  EXPECT_THAT(inclusive_range(-0.3, 0.3, 0.3, "x"), testing::ElementsAre(-0.3, 0.0, 0.3));
}

TEST(InclusiveRange, OfOnePointNeedsNoRoom) {
  EXPECT_THAT(inclusive_range(20, 20, 5, "x"), testing::ElementsAre(20));
}

TEST(InclusiveRange, HoldsEveryTenthUpToAThousand) {
  const std::vector<double> values = inclusive_range(0, 1000, 0.1, "x");
  ASSERT_EQ(values.size(), 10001u);
  for (std::size_t k = 0; k < values.size(); ++k)
    ASSERT_EQ(values[k], std::stod(std::to_string(k / 10) + "." + std::to_string(k % 10))) << k;
}

TEST(InclusiveRange, RefusesAStepThatVanishesBesideItsStart) {
  EXPECT_THROW(inclusive_range(1e17, 1e17 + 64, 1, "x"), InputError);
}

}  // namespace
}  // namespace eerie::sweeps
