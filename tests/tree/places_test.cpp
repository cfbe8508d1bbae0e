// g++ 12 takes the undefined operands of its own AVX-512 headers for faults (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "solver/tree/places.hpp"

#include <gtest/gtest.h>

#include <set>

#include "solver/base/random.hpp"

namespace eerie::tree {
namespace {

TEST(Places, PacksNearAPointHoldAllThatIsNearAndLeaveOutWhatIsFar) {
  // Knots along a line: a pack or two each, so that most packs are far from any one point.
  Random random(7, 0);
  for (const std::size_t count : {std::size_t{1}, std::size_t{16}, std::size_t{500}}) {
    Places places;
    places.fill(count, [&](std::size_t k) {
      return Vec3{static_cast<double>(k) / 8, 0, 0} + random.uniform() * random.direction();
    });
    for (int n = 0; n < 100; ++n) {
      const auto x = static_cast<float>(random.uniform(-2, 65)),
                 y = static_cast<float>(random.uniform(-2, 2)), z = 0.3f, r2 = 2.5f;
      std::set<std::size_t> visited;
      places.visit_packs_near(x, y, z, r2, [&](std::size_t first) { visited.insert(first); });
      for (std::size_t first = 0; first < places.x.size(); first += lanes<float>)
        if (lanes_below(places.distance2(first, x, y, z), r2) != 0) {
          EXPECT_EQ(visited.count(first), 1u) << "pack " << first << " of " << count;
        }
      if (count == 500) {
        EXPECT_LT(visited.size() * lanes<float>, 100u) << "nearly all of 500 were visited";
      }
    }
  }
}

TEST(Places, PaddingIsNearNothing) {
  Places places;
  places.fill(3, [](std::size_t k) { return Vec3{static_cast<double>(k), 0, 0}; });
  EXPECT_EQ(places.x.size() % lanes<float>, 0u);
  std::uint32_t near = 0;
  places.visit_packs_near(0, 0, 0, 100, [&](std::size_t first) {
    near |= lanes_below(places.distance2(first, 0, 0, 0), 100.0f) << first;
  });
  EXPECT_EQ(near, 7u);
}

}  // namespace
}  // namespace eerie::tree
