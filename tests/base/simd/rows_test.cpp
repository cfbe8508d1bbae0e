// g++ 12 takes the undefined operands of its own AVX-512 headers for faults (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "solver/base/simd/rows.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/base/simd/random_pack.hpp"

namespace eerie {
namespace {

using test::random_pack;

template <class T>
class SimdRows : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(SimdRows, Reals);

TYPED_TEST(SimdRows, ColumnsPickTheRightNumberOfTheRightRow) {
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

TYPED_TEST(SimdRows, StoredQuadsLieWhereTheirPlaceSays) {
  Random random(3, 0);
  Pack<TypeParam> in[4];
  for (auto& p : in) p = random_pack<TypeParam>(random, -1, 1);
  alignas(64) TypeParam out[4 * lanes<TypeParam>];
  store_quads<TypeParam>(in[0], in[1], in[2], in[3], out);
  for (int l = 0; l < lanes<TypeParam>; ++l)
    for (int k = 0; k < 4; ++k) EXPECT_EQ(out[quad_place<TypeParam>(l) + k], in[k][l]);
}

TYPED_TEST(SimdRows, QuadSumsWeighEachNumberOfARowByItsPlaceInTheQuad) {
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

}  // namespace
}  // namespace eerie
