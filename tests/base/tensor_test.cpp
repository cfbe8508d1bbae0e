#include "solver/base/tensor.hpp"

#include <gtest/gtest.h>

#include "tests/support/particles.hpp"

namespace eerie {
namespace {

TEST(SymTensor, InverseTimesItselfIsTheIdentity) {
  Random random(1, 0);
  for (int n = 0; n < 100; ++n) {
    SymTensor s = test::random_tensor(random);
    s.xx += 4, s.yy += 4, s.zz += 4;  // well conditioned
    const Mat3 one = to_matrix(s) * to_matrix(inverse(s, determinant(s)));
    // Condition numbers below ten: a few roundings.
    EXPECT_LT(test::largest_entry(test::difference(one, Mat3::identity())), 1e-14);
  }
}

TEST(SymTensor, ContractionCountsOffDiagonalsTwice) {
  const SymTensor s{1, 2, 3, 4, 5, 6};
  const Mat3 m = to_matrix(s);
  double sum = 0;
  for (int k = 0; k < 9; ++k) sum += m[k / 3][k % 3] * m[k / 3][k % 3];
  EXPECT_DOUBLE_EQ(contract(s), sum);
  EXPECT_DOUBLE_EQ(second_invariant(s), sum / 2);
}

TEST(SymTensor, InvariantsDoNotSeeRotations) {
  Random random(2, 0);
  for (int n = 0; n < 100; ++n) {
    const SymTensor s = test::random_tensor(random);
    const Mat3 R = test::rotation(random.direction(), random.uniform(0, 2 * pi));
    const Mat3 m = R * to_matrix(s) * transpose(R);
    const SymTensor t{m[0][0], m[1][1], m[2][2], m[0][1], m[0][2], m[1][2]};
    // Sums of nine products below one: a few roundings.
    EXPECT_NEAR(trace(t), trace(s), 1e-14);
    EXPECT_NEAR(contract(t), contract(s), 1e-14);
    EXPECT_NEAR(determinant(t), determinant(s), 1e-14);
  }
}

TEST(Vec3, CrossProductIsRightHandedAndNormal) {
  EXPECT_EQ(cross({1, 0, 0}, {0, 1, 0}), (Vec3{0, 0, 1}));
  const Vec3 a{1, 2, 3}, b{-2, 0.5, 7};
  EXPECT_NEAR(dot(cross(a, b), a), 0, 1e-14);
  EXPECT_NEAR(norm2(cross(a, b)) + dot(a, b) * dot(a, b), norm2(a) * norm2(b), 1e-12);
}

}  // namespace
}  // namespace eerie
