#include "campaign/sweeps/axis.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "campaign/sweeps/scene_field.hpp"
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

TEST(CanonicalNumber, KeepsTwelveDigitsOfAFractionAndEveryDigitOfAnInteger) {
  EXPECT_EQ(canonical_number(0.30000000000000004), nlohmann::json(0.3));
  EXPECT_EQ(canonical_number(0.1 + 0.7).dump(), "0.8");
  EXPECT_EQ(canonical_number(-0.0).dump(), "0");
  EXPECT_EQ(canonical_number(30.0).dump(), "30");
  EXPECT_EQ(canonical_number(29.999999999999996).dump(), "30");
  EXPECT_EQ(canonical_number(4503599627370497.0).dump(), "4503599627370497");
  EXPECT_NE(canonical_number(0.3), canonical_number(0.300000000001));
}

TEST(ParseAxis, NumbersThatDifferBeyondTwelveDigitsAreOne) {
  const Axis axis = parse_axis("impact.q", {0.30000000000000004, 0.5}, "s");
  EXPECT_THAT(axis.values, testing::ElementsAre(0.3, 0.5));
  EXPECT_THROW(parse_axis("impact.q", {0.3, 0.30000000000000004}, "s"), InputError);
  const nlohmann::json range = {{"from", 0.1}, {"to", 0.30000000000000004}, {"step", 0.1}};
  EXPECT_THAT(parse_axis("impact.q", range, "s").values, testing::ElementsAre(0.1, 0.2, 0.3));
}

}  // namespace
}  // namespace eerie::sweeps
