#include "analysis/shapes/shape.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "solver/base/constants.hpp"
#include "tests/analysis/remnants/bodies.hpp"

namespace eerie::shapes {
namespace {

using test::ellipsoid;
using test::moved;
using test::rotation;
using testing::HasSubstr;

const Vec3 tilt{0.3, -1, 0.7};

TEST(Shape, TiltedEllipsoidHasItsFullLengths) {
  const auto x = moved(ellipsoid({100, 50, 30}, 2), rotation(tilt, 1.1), {1e4, -2e3, 50});
  const Shape shape = ellipsoid_of_inertia(x);
  // About 78,000 points: lattice and surface steps are worth some 0.2 %.
  EXPECT_NEAR(shape.a, 200, 0.4);
  EXPECT_NEAR(shape.b, 100, 0.3);
  EXPECT_NEAR(shape.c, 60, 0.3);
  EXPECT_NEAR(shape.b_over_a(), 0.5, 0.002);
  EXPECT_NEAR(shape.c_over_a(), 0.3, 0.002);
  EXPECT_EQ(shape.degenerate, "");
}

TEST(Shape, AxesPointAlongTheBody) {
  const Mat3 turn = rotation(tilt, 1.1);
  const Shape shape = ellipsoid_of_inertia(moved(ellipsoid({100, 50, 30}, 5), turn, {}));
  for (int k = 0; k < 3; ++k) {
    const Vec3 wanted{turn[0][k], turn[1][k], turn[2][k]};
    EXPECT_NEAR(std::abs(dot(shape.axes[static_cast<std::size_t>(k)], wanted)), 1, 1e-6) << k;
  }
  EXPECT_NEAR(dot(cross(shape.axes[0], shape.axes[1]), shape.axes[2]), 1, 1e-12);
}

TEST(Shape, SphereHasThreeEqualLengths) {
  const Shape shape = ellipsoid_of_inertia(ellipsoid({50, 50, 50}, 3));
  EXPECT_NEAR(shape.a, 100, 0.2);
  EXPECT_NEAR(shape.c_over_a(), 1, 1e-9);
}

TEST(Shape, PointsFallShortByTheMomentOfOneCell) {
  // A cuboid of n cells of spacing s, seen as points, has second moments (L^2 - s^2)/12.
  std::vector<Vec3> x;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 10; ++j)
      for (int k = 0; k < 5; ++k) x.push_back({1.0 * i, 1.0 * j, 1.0 * k});
  const Shape shape = ellipsoid_of_inertia(x);
  EXPECT_NEAR(shape.a, std::sqrt(20 * (20.0 * 20 - 1) / 12), 1e-9);
  EXPECT_NEAR(shape.b, std::sqrt(20 * (10.0 * 10 - 1) / 12), 1e-9);
  EXPECT_NEAR(shape.c, std::sqrt(20 * (5.0 * 5 - 1) / 12), 1e-9);
}

TEST(Shape, AgreesWithThePrincipalMomentsOfThePaper) {
  // a = sqrt(10 (I1 + I2 - I3)/M) from moments computed along known axes.
  const auto x = ellipsoid({90, 60, 20}, 5);
  double xx = 0, yy = 0, zz = 0;
  for (const Vec3& p : x) xx += p.x * p.x, yy += p.y * p.y, zz += p.z * p.z;
  const double i1 = xx + yy, i2 = xx + zz, i3 = yy + zz, m = static_cast<double>(x.size());
  const Shape shape = ellipsoid_of_inertia(moved(x, rotation(tilt, -2), {7, 8, 9}));
  EXPECT_NEAR(shape.a, std::sqrt(10 * (i1 + i2 - i3) / m), 1e-9);
  EXPECT_NEAR(shape.b, std::sqrt(10 * (i1 - i2 + i3) / m), 1e-9);
  EXPECT_NEAR(shape.c, std::sqrt(10 * (-i1 + i2 + i3) / m), 1e-9);
}

TEST(Shape, RodIsALineWithTheReason) {
  std::vector<Vec3> x;
  for (int i = 0; i < 100; ++i) x.push_back(0.1 * i * tilt);
  const Shape shape = ellipsoid_of_inertia(x);
  EXPECT_NEAR(shape.a, std::sqrt(20 * (100.0 * 100 - 1) / 12) * 0.1 * norm(tilt), 1e-9);
  EXPECT_EQ(shape.b, 0);
  EXPECT_EQ(shape.c, 0);
  EXPECT_THAT(shape.degenerate, HasSubstr("on a line"));
}

TEST(Shape, SheetIsFlatWithTheReason) {
  std::vector<Vec3> x;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 30; ++j) x.push_back({1.0 * i, 1.0 * j, 0});
  const Shape shape = ellipsoid_of_inertia(moved(x, rotation(tilt, 0.4), {100, 0, 0}));
  EXPECT_GT(shape.b, 0);
  EXPECT_EQ(shape.c, 0);
  EXPECT_THAT(shape.degenerate, HasSubstr("in a plane"));
}

TEST(Shape, FewPointsHaveNoVolume) {
  EXPECT_THAT(ellipsoid_of_inertia({}).degenerate, HasSubstr("no volume"));
  const std::vector<Vec3> one = {{3, 4, 5}};
  EXPECT_EQ(ellipsoid_of_inertia(one).a, 0);
  EXPECT_EQ(ellipsoid_of_inertia(one).b_over_a(), 0);
  const std::vector<Vec3> three = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_THAT(ellipsoid_of_inertia(three).degenerate, HasSubstr("3 particles"));
}

TEST(Spin, RigidBodyTurnsAsItWasSpun) {
  const auto x = moved(ellipsoid({100, 50, 30}, 6), rotation(tilt, 0.9), {1e4, 5e3, 0});
  const Vec3 omega{1e-4, -2e-4, 3e-4};  // about no principal axis
  const auto found = angular_velocity(x, test::spinning(x, omega, {0.1, 0.2, -0.3}));
  ASSERT_TRUE(found);
  EXPECT_LT(norm(*found - omega), 1e-12 * norm(omega) + 1e-15);
}

TEST(Spin, DriftAloneIsNoSpin) {
  const auto x = moved(ellipsoid({100, 50, 30}, 6), rotation(tilt, 0.9), {1e4, 5e3, 0});
  const auto found = angular_velocity(x, std::vector<Vec3>(x.size(), {0.1, 0.2, -0.3}));
  ASSERT_TRUE(found);
  EXPECT_LT(norm(*found), 1e-15);
}

TEST(Spin, SwellingAloneIsNoSpin) {
  const auto x = ellipsoid({100, 50, 30}, 6);
  std::vector<Vec3> v;
  for (const Vec3& p : x) v.push_back(1e-4 * p);
  EXPECT_LT(norm(angular_velocity(x, v).value()), 1e-17);
}

TEST(Spin, LineHasNoneThatCouldBeMeasured) {
  std::vector<Vec3> x;
  for (int i = 0; i < 10; ++i) x.push_back(0.1 * i * tilt);
  EXPECT_FALSE(angular_velocity(x, x));
  EXPECT_FALSE(angular_velocity({}, {}));
}

}  // namespace
}  // namespace eerie::shapes
