#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/proof/tension.hpp"

namespace eerie::proof {
namespace {

TEST(Tension, StrengthGrowsWithTheRateAsFlawsAndCracksDemand) {
  const double slow = 10, fast = 1e4;
  const auto strength = [](double rate) {
    const Pull p{rate, matching_spacing(rate), 9};
    const Strength s = pull(p);
    // Uniform strain until it breaks: the solver adds inertia only, a few percent.
    EXPECT_NEAR(s.peak / peak_without_inertia(p), 1, 0.05) << rate;
    EXPECT_GT(s.peak, weakest_flaw(p.spacing, std::pow(p.across, 3)));
    return s.peak;
  };
  const double exponent = std::log(strength(fast) / strength(slow)) / std::log(fast / slow);
  RecordProperty("exponent", std::to_string(exponent));
  // 3/(m + 3) with m = 9.
  EXPECT_NEAR(exponent, 0.25, 0.01);
}

}  // namespace
}  // namespace eerie::proof
