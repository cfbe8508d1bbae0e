#include "solver/step/deformation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace eerie::step {
namespace {

/// A cubic lattice of spacing 1 m with h = 1.2 m, and velocities of one linear flow.
template <class Flow>
particles::State lattice(Flow&& flow) {
  particles::State s;
  s.mass = 1, s.h = 1.2;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j)
      for (int k = 0; k < 12; ++k) {
        s.x.emplace_back(i, j, k);
        s.v.push_back(flow(s.x.back()));
      }
  return s;
}

TEST(DeformationRate, IsTheRateOfAUniformExpansion) {
  EXPECT_NEAR(deformation_rate(lattice([](const Vec3& x) { return 0.3 * x; })), 0.3, 1e-12);
}

TEST(DeformationRate, OfARotationIsRootTwoThirdsOfItWhereNeighboursAreAllAround) {
  // <|w x d|^2>/<d^2> = w^2 (1 - <cos^2>) = 2/3 w^2 over directions that a cube holds equally. On
  // the two faces across the axis neighbours lie aside of it rather: there it is up to 1.
  const Vec3 w{0, 0, 0.5};
  const double rate = deformation_rate(lattice([&](const Vec3& x) { return cross(w, x); }));
  EXPECT_GE(rate, std::sqrt(2. / 3) * 0.5 * (1 - 1e-12));
  EXPECT_LT(rate, 0.5);
}

TEST(DeformationRate, IgnoresWhereMatterGoesAndOneOfAThousandThatFlies) {
  particles::State s = lattice([](const Vec3&) { return Vec3{5, 6, 7}; });
  EXPECT_EQ(deformation_rate(s), 0);
  s.x.emplace_back(100, 0, 0), s.v.emplace_back(-50, 0, 0);  // far from all others
  EXPECT_EQ(deformation_rate(s), 0);
}

}  // namespace
}  // namespace eerie::step
