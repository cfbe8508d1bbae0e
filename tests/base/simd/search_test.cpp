// g++ 12 takes the undefined operands of its own AVX-512 headers for faults (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "solver/base/simd/search.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/base/simd/random_pack.hpp"

namespace eerie {
namespace {

using test::random_pack;

TEST(SimdSearch, LanesBelowSetsABitForEachLaneBelowTheLimit) {
  Random random(5, 0);
  for (int n = 0; n < 200; ++n) {
    Pack<float> p = random_pack<float>(random, 0, 1);
    p[1] = 0.4f;  // not below
    p[2] = std::numeric_limits<float>::quiet_NaN();
    std::uint32_t expected = 0;
    for (int l = 0; l < lanes<float>; ++l) expected |= (p[l] < 0.4f ? 1u : 0u) << l;
    EXPECT_EQ(lanes_below(p, 0.4f), expected);
  }
}

TEST(SimdSearch, AppendLessKeepsTheIdsOfLanesBelowTheLimitInOrder) {
  Random random(4, 0);
  std::uint16_t ids[lanes<float>];
  for (int l = 0; l < lanes<float>; ++l) ids[l] = static_cast<std::uint16_t>(1000 + 4 * l);
  for (int n = 0; n < 200; ++n) {
    const Pack<float> p = random_pack<float>(random, 0, 1);
    std::uint16_t found[2 * lanes<float>];
    std::uint16_t* end = append_less(p, 0.4f, ids, found);
    std::vector<std::uint16_t> expected;
    for (int l = 0; l < lanes<float>; ++l)
      if (p[l] < 0.4f) expected.push_back(ids[l]);
    EXPECT_EQ(std::vector<std::uint16_t>(found, end), expected);
  }
}

TEST(SimdSearch, AppendLessCountsOnFromTheFirstIndex) {
  Random random(6, 0);
  for (int n = 0; n < 200; ++n) {
    const Pack<double> p = random_pack<double>(random, 0, 1);
    std::uint32_t found[2 * lanes<double>];
    std::uint32_t* end = append_less(p, 0.4, 70'000, found);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t l = 0; l < lanes<double>; ++l)
      if (p[l] < 0.4) expected.push_back(70'000 + l);
    EXPECT_EQ(std::vector<std::uint32_t>(found, end), expected);
  }
}

TEST(SimdSearch, LoadVectorsTakesComponentsApartAndReadsNothingBeyondTheLast) {
  for (std::size_t count = 0; count <= lanes<double>; ++count) {
    std::vector<double> xyz(3 * count);  // the sanitizer watches its end
    for (std::size_t k = 0; k < xyz.size(); ++k) xyz[k] = static_cast<double>(k + 1);
    const VectorPacks v = load_vectors(xyz.data(), count);
    for (std::size_t l = 0; l < lanes<double>; ++l) {
      const double x = l < count ? static_cast<double>(3 * l + 1) : 0;
      EXPECT_EQ(v.x[l], x) << count << " " << l;
      EXPECT_EQ(v.y[l], l < count ? x + 1 : 0) << count << " " << l;
      EXPECT_EQ(v.z[l], l < count ? x + 2 : 0) << count << " " << l;
    }
  }
}

}  // namespace
}  // namespace eerie
