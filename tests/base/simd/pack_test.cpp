// g++ 12 takes the undefined operands of its own AVX-512 headers for faults (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "solver/base/simd/pack.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/base/simd/random_pack.hpp"

namespace eerie {
namespace {

using test::random_pack;

template <class T>
class Simd : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Simd, Reals);

TYPED_TEST(Simd, PositivePartCutsBelowZeroAndAtNaN) {
  Random random(1, 0);
  Pack<TypeParam> p = random_pack<TypeParam>(random, -1, 1);
  p[0] = std::numeric_limits<TypeParam>::quiet_NaN();
  const Pack<TypeParam> cut = positive_part(p);
  EXPECT_EQ(cut[0], 0);
  for (int l = 1; l < lanes<TypeParam>; ++l) EXPECT_EQ(cut[l], p[l] > 0 ? p[l] : 0);
}

TYPED_TEST(Simd, InverseAndInverseSqrtReachThePrecisionOfTheType) {
  Random random(2, 0);
  // A Newton step from 14 bits leaves 1.5 * 2^-28 for float, a second one rounding for double.
  const double tolerance = 4 * static_cast<double>(std::numeric_limits<TypeParam>::epsilon());
  for (int n = 0; n < 1000; ++n) {
    const Pack<TypeParam> x = random_pack<TypeParam>(random, 0, std::pow(10., n % 20 - 10));
    const Pack<TypeParam> root = inverse_sqrt(x), one_over = inverse(x);
    for (int l = 0; l < lanes<TypeParam>; ++l) {
      const double exact = static_cast<double>(x[l]);
      EXPECT_NEAR(static_cast<double>(root[l]) * std::sqrt(exact), 1, tolerance) << exact;
      EXPECT_NEAR(static_cast<double>(one_over[l]) * exact, 1, tolerance) << exact;
    }
  }
}

TYPED_TEST(Simd, LaneSumsAddEveryLaneOfEveryPack) {
  Random random(3, 0);
  Pack<TypeParam> in[11];
  TypeParam out[16];
  for (auto& p : in) p = random_pack<TypeParam>(random, -1, 1);
  lane_sums(in, out);
  for (int k = 0; k < 11; ++k) {
    double sum = 0;
    for (int l = 0; l < lanes<TypeParam>; ++l) sum += static_cast<double>(in[k][l]);
    // At most sixteen numbers below one: sixteen roundings.
    EXPECT_NEAR(static_cast<double>(out[k]), sum,
                16 * static_cast<double>(std::numeric_limits<TypeParam>::epsilon()));
  }
}

}  // namespace
}  // namespace eerie
