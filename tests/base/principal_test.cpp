#include "solver/base/principal.hpp"

#include <gtest/gtest.h>

#include "tests/support/particles.hpp"

namespace eerie {
namespace {

TEST(Principal, OfADiagonalTensorIsItsLargestEntry) {
  EXPECT_DOUBLE_EQ(largest_principal({-3, 2, 1, 0, 0, 0}), 2);
  EXPECT_DOUBLE_EQ(largest_principal({-3, -2, -1, 0, 0, 0}), -1);
  EXPECT_DOUBLE_EQ(largest_principal({5, 5, 5, 0, 0, 0}), 5);
}

TEST(Principal, StaysWhenTheTensorTurns) {
  const SymTensor s{4e6, -2e6, 1e6, 0, 0, 0}, tensile{4e6, 0, 1e6, 0, 0, 0};
  for (double angle = 0; angle < 6; angle += 0.37) {
    const Mat3 R = test::rotation(Vec3{2, -1, 2} / 3, angle);
    EXPECT_NEAR(largest_principal(turned(s, R)), 4e6, 1e-6);  // rounding of 1e6
    const SymTensor d = positive_part(turned(s, R)) + -1.0 * turned(tensile, R);
    EXPECT_LT(contract(d), 1e-16 * contract(s));
  }
}

TEST(Principal, PositivePartOfPureCompressionIsNothing) {
  EXPECT_EQ(contract(positive_part({-1, -2, -3, 0.1, 0.2, 0.3})), 0);
}

}  // namespace
}  // namespace eerie
