#include "solver/base/bodies/sphere.hpp"

#include <gtest/gtest.h>

namespace eerie {
namespace {

/// Whether friction bears the stresses of a spinning sphere, averaged over its volume.
bool stands(double omega, double rho, double mu) {
  const double own = 4 * pi / 3 * newton_G * rho;
  const double across = omega * omega - own, along = -own;  // times rho R^2/5; tension is positive
  const double p = -(2 * across + along) / 3;
  const double s_across = across + p, s_along = along + p;
  const double J2 = (2 * s_across * s_across + s_along * s_along) / 2;
  return std::sqrt(J2) <= mu * p && omega * omega <= own;
}

TEST(FastestSpin, IsWhereFrictionNoLongerBearsTheStresses) {
  for (const double mu : {0.1, 0.36, 0.84, 1.19, 1.7, 3.0}) {
    const double omega = fastest_spin(2700, mu);
    EXPECT_TRUE(stands(0.9999 * omega, 2700, mu)) << mu;
    EXPECT_FALSE(stands(1.0001 * omega, 2700, mu)) << mu;
  }
  EXPECT_EQ(fastest_spin(2700, 0), 0);
}

}  // namespace
}  // namespace eerie
