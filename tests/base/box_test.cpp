#include "solver/base/box.hpp"

#include <gtest/gtest.h>

#include "solver/base/random.hpp"

namespace eerie {
namespace {

Vec3 point(Random& random) {
  return {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
}

TEST(Box, DistanceIsThatOfTheNearestPoint) {
  Random random(1, 0);
  Box box;
  box.include(Vec3{-1, -0.5, 0});
  box.include(Vec3{1, 0.5, 0.2});
  for (int n = 0; n < 1000; ++n) {
    const Vec3 p = point(random);
    Vec3 nearest = p;
    for (int k = 0; k < 3; ++k) nearest[k] = std::clamp(p[k], box.lo[k], box.hi[k]);
    EXPECT_DOUBLE_EQ(distance2(box, p), norm2(p - nearest));
  }
}

TEST(Box, DistanceOfBoxesIsNeverAboveThatOfTheirPoints) {
  Random random(2, 0);
  for (int n = 0; n < 1000; ++n) {
    Box a, b;
    const Vec3 p = point(random), q = point(random);
    a.include(p), a.include(point(random));
    b.include(q), b.include(point(random));
    EXPECT_LE(distance2(a, b), norm2(p - q));
    EXPECT_LE(distance2(a, b), distance2(a, q));
    EXPECT_EQ(distance2(a, b), distance2(b, a));
  }
}

TEST(Random, StreamsOfOneSeedDifferAndRepeat) {
  Random a(1, 0), again(1, 0), other_stream(1, 1), other_seed(2, 0);
  const double first = a.uniform();
  EXPECT_EQ(first, again.uniform());
  EXPECT_NE(first, other_stream.uniform());
  EXPECT_NE(first, other_seed.uniform());
}

TEST(Random, DirectionsAreUniformOnTheSphere) {
  Random random(3, 0);
  Vec3 mean;
  double zz = 0;
  constexpr int n = 100000;
  for (int k = 0; k < n; ++k) {
    const Vec3 d = random.direction();
    ASSERT_NEAR(norm(d), 1, 1e-14);
    mean += d / n;
    zz += d.z * d.z / n;
  }
  // Five standard deviations, 1/sqrt(3 n) and sqrt(4/45 / n).
  EXPECT_LT(norm(mean), 5 / std::sqrt(1.0 * n));
  EXPECT_NEAR(zz, 1.0 / 3, 5 * 0.3 / std::sqrt(1.0 * n));
}

}  // namespace
}  // namespace eerie
