#include "analysis/shapes/shape_class.hpp"

#include <gtest/gtest.h>

#include "tests/analysis/remnants/bodies.hpp"

namespace eerie::shapes {
namespace {

constexpr double h = 1.2 * test::spacing;
const Mat3 turned = test::rotation({1, 2, 3}, 0.7);

/// Two equal balls with their centres so far apart along x, as one body.
std::vector<Vec3> two_balls(double radius, double apart) {
  std::vector<Vec3> x;
  for (const Vec3& p : test::ellipsoid({radius + apart, radius + apart, radius + apart}, 5)) {
    const Vec3 arm{apart / 2, 0, 0};
    if (norm(p - arm) <= radius || norm(p + arm) <= radius) x.push_back(p);
  }
  return x;
}

ShapeClass class_of(const std::vector<Vec3>& body) {
  const std::vector<Vec3> x = test::moved(body, turned, {10, 20, 30});
  const Shape shape = ellipsoid_of_inertia(x);
  return classify_shape(shape, neck(x, shape.axes[0], h));
}

TEST(ShapeClass, OfEllipsoidsFollowsTheirAxes) {
  EXPECT_EQ(class_of(test::ellipsoid({60, 60, 60}, 5)), ShapeClass::spherical);
  EXPECT_EQ(class_of(test::ellipsoid({60, 50, 40}, 5)), ShapeClass::spherical);
  EXPECT_EQ(class_of(test::ellipsoid({80, 75, 35}, 5)), ShapeClass::flat);
  EXPECT_EQ(class_of(test::ellipsoid({100, 50, 45}, 5)), ShapeClass::elongated);
  EXPECT_EQ(class_of(test::ellipsoid({150, 40, 20}, 5)), ShapeClass::elongated);
}

TEST(ShapeClass, OfTwoBallsIsBilobedWhileTheirCentresAreMoreThanARadiusApart) {
  EXPECT_EQ(class_of(two_balls(60, 120)), ShapeClass::bilobed);
  EXPECT_EQ(class_of(two_balls(60, 80)), ShapeClass::bilobed);
  EXPECT_EQ(class_of(two_balls(60, 40)), ShapeClass::spherical);
}

TEST(ShapeClass, OfARodIsNotBilobedHoweverLongItIs) {
  std::vector<Vec3> rod;
  for (const Vec3& p : test::ellipsoid({400, 400, 400}, 10))
    if (std::hypot(p.y, p.z) <= 40 && std::abs(p.x) <= 200) rod.push_back(p);
  EXPECT_EQ(class_of(rod), ShapeClass::elongated);
}

TEST(Neck, OfOverlappingBallsIsTheRatioOfTheirCrossSections) {
  // The Gaussian fills the neck and rounds the lobes: a tenth.
  for (const double apart : {70.0, 90.0, 110.0}) {
    const std::vector<Vec3> x = two_balls(60, apart);
    EXPECT_NEAR(neck(x, {1, 0, 0}, 3), 1 - std::pow(apart / 120, 2), 0.1) << apart;
  }
  EXPECT_LT(neck(two_balls(60, 110), {1, 0, 0}, 3), neck(two_balls(60, 90), {1, 0, 0}, 3));
}

TEST(Neck, IsNoneBeforeALobeOfLessThanATenthOfTheMass) {
  std::vector<Vec3> x = test::ellipsoid({60, 60, 60}, 5);
  const std::size_t ball = x.size();
  for (const Vec3& p : test::ellipsoid({20, 20, 20}, 5)) x.push_back(p + Vec3{80, 0, 0});
  ASSERT_LT(static_cast<double>(x.size() - ball), lobe_min_mass * static_cast<double>(ball));
  EXPECT_GT(neck(x, {1, 0, 0}, h), bilobed_max_neck);
}

TEST(Neck, OfNothingOrAFewParticlesIsNone) {
  EXPECT_EQ(neck({}, {1, 0, 0}, h), 1);
  EXPECT_EQ(neck(std::vector<Vec3>{{1, 2, 3}}, {1, 0, 0}, h), 1);
}

}  // namespace
}  // namespace eerie::shapes
