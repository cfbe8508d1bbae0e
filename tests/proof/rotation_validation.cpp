#include <gtest/gtest.h>

#include "tests/proof/rotation.hpp"

namespace eerie::proof {
namespace {

TEST(RotatingRigidBody, KeepsItsSpinByTheCorrectedGradientAlone) {
  const Rotated corrected = rotated_sphere("corrected", 1), plain = rotated_sphere("plain", 1);
  // Exact rotation makes no stress; the correction in the force is one step old, 2e-4 a turn.
  EXPECT_NEAR(corrected.angular_momentum.back(), 1, 1e-3);
  EXPECT_NEAR(corrected.radius.back(), 1, 0.01);
  // Without the correction rotation strains the surface, and that brakes it.
  EXPECT_LT(plain.angular_momentum.back(), 0.9);
}

}  // namespace
}  // namespace eerie::proof
