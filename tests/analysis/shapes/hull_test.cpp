#include "analysis/shapes/hull.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/shapes/shape.hpp"
#include "solver/base/constants.hpp"
#include "tests/analysis/remnants/bodies.hpp"

namespace eerie::shapes {
namespace {

const Vec3 tilt{0.3, -1, 0.7};

std::vector<Vec3> corners(const Vec3& half) {
  std::vector<Vec3> x;
  for (const double i : {-1, 1})
    for (const double j : {-1, 1})
      for (const double k : {-1, 1}) x.push_back({i * half.x, j * half.y, k * half.z});
  return x;
}

/// Points on the surface of an ellipsoid.
std::vector<Vec3> surface(const Vec3& half, int points) {
  Random random(5, 0);
  std::vector<Vec3> x;
  for (int i = 0; i < points; ++i) {
    const Vec3 n = random.direction();
    x.push_back({half.x * n.x, half.y * n.y, half.z * n.z});
  }
  return x;
}

double volume(const HullBox& box) { return box.a * box.b * box.c; }

TEST(HullBox, OfABoxIsThatBoxHoweverItLies) {
  for (const double angle : {0.0, 0.4, 1.1, 2.7}) {
    const HullBox box = box_of_hull(
        test::moved(corners({50, 20, 10}), test::rotation(tilt, angle), {1e4, -300, 7}));
    EXPECT_NEAR(box.a, 100, 0.01) << angle;
    EXPECT_NEAR(box.b, 40, 0.01) << angle;
    EXPECT_NEAR(box.c, 20, 0.01) << angle;
    EXPECT_NEAR(norm(box.centre - Vec3{1e4, -300, 7}), 0, 0.01);
    const Vec3 wanted = test::rotation(tilt, angle) * Vec3{1, 0, 0};
    EXPECT_NEAR(std::abs(dot(box.axes[0], wanted)), 1, 1e-6);
    EXPECT_NEAR(dot(cross(box.axes[0], box.axes[1]), box.axes[2]), 1, 1e-12);
  }
}

TEST(HullBox, OfAnEllipsoidHasItsAxes) {
  // Of all boxes about an ellipsoid the one along its axes is the smallest (Hadamard's inequality).
  const HullBox box = box_of_hull(
      test::moved(surface({100, 50, 30}, 30000), test::rotation(tilt, 1.1), {0, 40, 0}));
  EXPECT_NEAR(box.a, 200, 1);
  EXPECT_NEAR(box.b, 100, 1);
  EXPECT_NEAR(box.c, 60, 1);
  EXPECT_NEAR(box.b_over_a(), 0.5, 0.005);
  EXPECT_NEAR(box.c_over_a(), 0.3, 0.005);
}

TEST(HullBox, OfTwoTouchingSpheresIsHalfAsWideAsLongWhereInertiaSaysLess) {
  std::vector<Vec3> x = test::moved(test::ellipsoid({30, 30, 30}, 2), Mat3::identity(), {30, 0, 0});
  const auto other = test::moved(x, Mat3::identity(), {-60, 0, 0});
  x.insert(x.end(), other.begin(), other.end());
  x = test::moved(x, test::rotation(tilt, 0.6), {});
  const HullBox box = box_of_hull(x);
  EXPECT_NEAR(box.a, 120, 2);
  EXPECT_NEAR(box.b_over_a(), 0.5, 0.01);
  EXPECT_NEAR(box.c_over_a(), 0.5, 0.01);
  EXPECT_NEAR(ellipsoid_of_inertia(x).b_over_a(), 1 / std::sqrt(6.0), 0.005);
}

TEST(HullBox, IsNoLargerThanTheBoxAlongThePrincipalAxes) {
  // A bent body: three bars of an L and a foot.
  std::vector<Vec3> x;
  for (const Vec3& p : corners({60, 5, 5})) x.push_back(p);
  for (const Vec3& p : corners({5, 40, 5})) x.push_back(p + Vec3{55, 35, 0});
  for (const Vec3& p : corners({5, 5, 20})) x.push_back(p + Vec3{-55, 0, 15});
  x = test::moved(x, test::rotation(tilt, 2.2), {});
  const Shape shape = ellipsoid_of_inertia(x);
  double principal = 1;
  for (const Vec3& axis : shape.axes) {
    double low = 1e9, high = -1e9;
    for (const Vec3& p : x) low = std::min(low, dot(axis, p)), high = std::max(high, dot(axis, p));
    principal *= high - low;
  }
  EXPECT_LT(volume(box_of_hull(x)), 0.95 * principal);
}

TEST(HullBox, OfARegularTetrahedronIsItsCube) {
  // Four corners of a cube; a local minimum would be larger.
  const std::vector<Vec3> x = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  EXPECT_NEAR(volume(box_of_hull(test::moved(x, test::rotation(tilt, 0.9), {}))), 8, 0.01);
}

TEST(HullBox, HoldsEveryPointAndTurnsWithTheBody) {
  const auto body = test::ellipsoid({60, 25, 20}, 3);
  const HullBox box = box_of_hull(body);
  for (const Vec3& p : body) {
    EXPECT_LE(std::abs(dot(p - box.centre, box.axes[0])), box.a / 2 + 1e-9);
    EXPECT_LE(std::abs(dot(p - box.centre, box.axes[1])), box.b / 2 + 1e-9);
    EXPECT_LE(std::abs(dot(p - box.centre, box.axes[2])), box.c / 2 + 1e-9);
  }
  const HullBox turned = box_of_hull(test::moved(body, test::rotation(tilt, 1), {9, 9, 9}));
  EXPECT_NEAR(volume(turned) / volume(box), 1, 5e-3);
}

TEST(HullBox, ParticlesAddTheirOwnSize) {
  const HullBox box = box_of_hull(corners({50, 20, 10}), 3);
  EXPECT_NEAR(box.a, 106, 0.01);
  EXPECT_NEAR(box.c, 26, 0.01);
  const std::vector<Vec3> one = {{1, 2, 3}};
  EXPECT_EQ(box_of_hull(one, 3).a, 6);
  EXPECT_EQ(box_of_hull(one, 3).b_over_a(), 1);
  EXPECT_EQ(box_of_hull({}).a, 0);
}

TEST(HullBox, LinesAndSheetsHaveNoWidthOfTheirOwn) {
  std::vector<Vec3> line;
  for (int i = 0; i <= 100; ++i) line.push_back(0.1 * i * tilt);
  const HullBox along = box_of_hull(line);
  EXPECT_NEAR(along.a, 10 * norm(tilt), 1e-6);
  EXPECT_NEAR(along.b, 0, 1e-3);
}

}  // namespace
}  // namespace eerie::shapes
