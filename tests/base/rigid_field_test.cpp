#include "solver/base/rigid_field.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "solver/base/mean.hpp"
#include "solver/base/random.hpp"

namespace eerie {
namespace {

RigidField fitted(const std::vector<Vec3>& x, const std::vector<Vec3>& v) {
  const Vec3 centre = mean(x);
  RigidSums sums;
  for (std::size_t i = 0; i < x.size(); ++i) sums.add(x[i] - centre, v[i]);
  return sums.field(centre, static_cast<double>(x.size()));
}

std::vector<Vec3> field_at(const RigidField& field, const std::vector<Vec3>& x) {
  std::vector<Vec3> v;
  for (const Vec3& at : x) v.push_back(field.at(at));
  return v;
}

TEST(RigidField, IsFoundInTheMotionOfARigidBody) {
  Random random(3, 0);
  std::vector<Vec3> x;
  for (int i = 0; i < 20; ++i) x.push_back(Vec3{30, -4, 7} + 5 * random.direction());
  const RigidField wanted{mean(x), {1, 2, 3}, {-0.2, 0.1, 0.4}};
  const RigidField found = fitted(x, field_at(wanted, x));
  EXPECT_LT(norm(found.mean - wanted.mean), 1e-13);
  EXPECT_LT(norm(found.spin - wanted.spin), 1e-13);
  EXPECT_LT(norm(found.at({1, 1, 1}) - wanted.at({1, 1, 1})), 1e-12);
}

TEST(RigidField, LeavesNoneInWhatItIsTakenOff) {
  Random random(4, 0);
  std::vector<Vec3> x, v;
  for (int i = 0; i < 50; ++i) x.push_back(3 * random.direction()), v.push_back(random.direction());
  const RigidField field = fitted(x, v);
  EXPECT_GT(norm(field.mean), 1e-3);
  EXPECT_GT(norm(field.spin), 1e-3);
  for (std::size_t i = 0; i < x.size(); ++i) v[i] -= field.at(x[i]);
  const RigidField left = fitted(x, v);
  EXPECT_LT(norm(left.mean) + norm(left.spin), 1e-14);
}

TEST(RigidField, OfTwoClumpsFarApartHasTheSpinOfBoth) {
  // A length of 1e5 for a width of 1: the spin about the line is still theirs.
  std::vector<Vec3> x;
  for (const double at : {0.0, 1e5})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) x.push_back({at, y, z});
  const RigidField wanted{mean(x), {}, {0.5, 0, 0.01}};
  EXPECT_LT(norm(fitted(x, field_at(wanted, x)).spin - wanted.spin), 1e-4);
}

TEST(RigidField, OfPlacesOnALineHasAMeanAlone) {
  const std::vector<Vec3> x = {{0, 0, 0}, {1, 2, 3}, {2, 4, 6}};
  const RigidField field = fitted(x, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  EXPECT_EQ(field.mean, (Vec3{2, 0, 0}));
  EXPECT_EQ(field.spin, Vec3{});
  const RigidField one = fitted({{5, 5, 5}}, {{0, 1, 0}});
  EXPECT_EQ(one.at({9, 9, 9}), (Vec3{0, 1, 0}));
}

}  // namespace
}  // namespace eerie
