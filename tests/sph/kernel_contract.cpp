// g++ 12 takes the undefined operands of its own AVX-512 headers for faults (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/sph/kernel.hpp"
#include "tests/support/variant_types.hpp"

namespace eerie::sph {
namespace {

/// What every kernel owes to the sums: q = r/h, support 2.
template <class Kernel>
class KernelContract : public testing::Test {};
TYPED_TEST_SUITE(KernelContract, test::AlternativesOf<KernelChoice>, test::NameByToken);

TYPED_TEST(KernelContract, IntegratesToOneInThreeDimensions) {
  // Midpoint rule: error of order dq^2 w''/24 ~ 1e-8 for 4,000 pieces.
  constexpr int pieces = 4000;
  double sum = 0;
  for (int k = 0; k < pieces; ++k) {
    const double dq = 2.0 / pieces, q = (k + 0.5) * dq;
    sum += 4 * pi * q * q * TypeParam::w(q) * dq;
  }
  EXPECT_NEAR(TypeParam::normalisation * sum, 1, 1e-6);
}

TYPED_TEST(KernelContract, GradientIsTheDerivative) {
  for (double q = 0.013; q < 2.2; q += 0.0171) {
    const double dq = 1e-5, slope = (TypeParam::w(q + dq) - TypeParam::w(q - dq)) / (2 * dq);
    // Central differences: truncation 1e-10, and a second derivative that jumps at q = 1 and 2
    // adds dq.
    EXPECT_NEAR(TypeParam::dw_over_q(q, 1 / q) * q, slope, 1e-4 * std::abs(slope) + 1e-9) << q;
  }
}

TYPED_TEST(KernelContract, FallsFromTheCentreToNothingAtTwiceH) {
  for (double q = 0.01; q < 1.99; q += 0.01) {
    EXPECT_GT(TypeParam::w(q), 0);
    EXPECT_LT(TypeParam::dw_over_q(q, 1 / q), 0);
  }
  for (const double q : {2.0, 2.001, 3.0, 1e3, 1e9}) {
    EXPECT_EQ(TypeParam::w(q), 0);
    EXPECT_EQ(TypeParam::dw_over_q(q, 1 / q), 0);
  }
}

template <class Kernel, class Real>
void expect_lanes_like_scalars() {
  // Vector and scalar code may contract multiply-adds differently: a few units in the last place
  // of the largest value.
  const Real tolerance = 8 * std::numeric_limits<Real>::epsilon();
  for (int start = 0; start < 200; start += lanes<Real>) {
    Pack<Real> q;
    for (int l = 0; l < lanes<Real>; ++l)
      q[l] = static_cast<Real>(0.0123) * static_cast<Real>(start + l + 1);
    const Pack<Real> w = Kernel::w(q), gradient = Kernel::dw_over_q(q, Pack<Real>(1 / q));
    for (int l = 0; l < lanes<Real>; ++l) {
      const Real one = q[l];
      EXPECT_NEAR(w[l], Kernel::w(one), tolerance * Kernel::w(Real(0)));
      const Real slope = Kernel::dw_over_q(one, 1 / one);
      EXPECT_NEAR(gradient[l] * one, slope * one, tolerance * 5);
    }
  }
}

TYPED_TEST(KernelContract, EveryLaneOfAPackIsTheScalarLaw) {
  expect_lanes_like_scalars<TypeParam, float>();
  expect_lanes_like_scalars<TypeParam, double>();
}

TYPED_TEST(KernelContract, IsFoundByItsToken) {
  EXPECT_TRUE(std::holds_alternative<TypeParam>(make_kernel(TypeParam::token)));
}

TEST(Kernel, UnknownNameIsRefused) { EXPECT_THROW(make_kernel("top-hat"), InputError); }

}  // namespace
}  // namespace eerie::sph
