// g++ 12 takes the undefined operands of its own AVX-512 headers for faults (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "solver/base/simd.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "solver/base/random.hpp"

namespace eerie {
namespace {

template <class T>
Pack<T> random_pack(Random& random, double lo, double hi) {
  Pack<T> p;
  for (int l = 0; l < lanes<T>; ++l) p[l] = static_cast<T>(random.uniform(lo, hi));
  return p;
}

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

TYPED_TEST(Simd, ColumnsPickTheRightNumberOfTheRightRow) {
  constexpr int stride = 8, count = 50;
  alignas(64) TypeParam rows[count * stride];
  for (int k = 0; k < count * stride; ++k) rows[k] = static_cast<TypeParam>(k);
  std::uint16_t place[lanes<TypeParam>];
  const auto row = [](int l) { return (7 * l + 3) % count; };
  for (int l = 0; l < lanes<TypeParam>; ++l)
    place[l] = static_cast<std::uint16_t>(row(l) * static_cast<int>(row_units<TypeParam>));
  const auto columns = load_columns(&rows[0], &place[0]);
  for (int l = 0; l < lanes<TypeParam>; ++l)
    for (int k = 0; k < 8; ++k)
      EXPECT_EQ(columns.c[k][l], static_cast<TypeParam>(row(l) * stride + k)) << l << " " << k;
}

TYPED_TEST(Simd, StoredQuadsLieWhereTheirPlaceSays) {
  Random random(3, 0);
  Pack<TypeParam> in[4];
  for (auto& p : in) p = random_pack<TypeParam>(random, -1, 1);
  alignas(64) TypeParam out[4 * lanes<TypeParam>];
  store_quads<TypeParam>(in[0], in[1], in[2], in[3], out);
  for (int l = 0; l < lanes<TypeParam>; ++l)
    for (int k = 0; k < 4; ++k) EXPECT_EQ(out[quad_place<TypeParam>(l) + k], in[k][l]);
}

TYPED_TEST(Simd, QuadSumsWeighEachNumberOfARowByItsPlaceInTheQuad) {
  constexpr int count = 23;
  Random random(4, 0);
  alignas(64) TypeParam rows[count * 16];
  for (TypeParam& x : rows) x = static_cast<TypeParam>(random.uniform(-1, 1));
  std::uint16_t place[lanes<TypeParam>];
  const auto row = [](int l) { return (5 * l + 2) % count; };
  for (int l = 0; l < lanes<TypeParam>; ++l)  // in units of rows of eight: half a row of sixteen
    place[l] = static_cast<std::uint16_t>(row(l) * static_cast<int>(row_units<TypeParam>));
  Pack<TypeParam> in[4];
  for (auto& p : in) p = random_pack<TypeParam>(random, -1, 1);
  alignas(64) TypeParam weights[4 * lanes<TypeParam>], out[16];
  store_quads<TypeParam>(in[0], in[1], in[2], in[3], weights);
  QuadSums<TypeParam> sums;
  sums.add(weights, rows, place);
  sums.store(out);
  for (int n = 0; n < 16; ++n) {
    double exact = 0;
    for (int l = 0; l < lanes<TypeParam>; ++l)
      exact += static_cast<double>(rows[row(l) * 16 + n]) * static_cast<double>(in[n % 4][l]);
    EXPECT_NEAR(static_cast<double>(out[n]), exact,
                32 * static_cast<double>(std::numeric_limits<TypeParam>::epsilon()));
  }
}

TEST(SimdSearch, AppendLessKeepsPlacesBelowTheLimitInOrder) {
  Random random(4, 0);
  for (int n = 0; n < 200; ++n) {
    const Pack<float> p = random_pack<float>(random, 0, 1);
    std::uint16_t found[2 * lanes<float>];
    std::uint16_t* end = append_less(p, 0.4f, 1000, found);
    std::vector<std::uint16_t> expected;
    for (int l = 0; l < lanes<float>; ++l)
      if (p[l] < 0.4f) expected.push_back(static_cast<std::uint16_t>(1000 + l));
    EXPECT_EQ(std::vector<std::uint16_t>(found, end), expected);
  }
}

}  // namespace
}  // namespace eerie
