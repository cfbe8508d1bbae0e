#include <gtest/gtest.h>

#include <cmath>

#include "solver/material/material.hpp"
#include "tests/support/particles.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/variant_types.hpp"

namespace eerie {
namespace {

using test::random_deviator;
using test::small_scene;

/// What every rheology of fully damaged material owes to the solver.
template <class Rheology>
class RheologyContract : public testing::Test {
 protected:
  /// Calls visit(rheology, S, p) for many stresses on both sides of the yield surface.
  template <class Visit>
  void for_many_stresses(Visit&& visit) {
    Random random(3, 0);
    for (const double phi_d : {0.0, 30.0, 60.0})
      for (const double cohesion : {0.0, 10.0}) {
        const Rheology rheology(
            small_scene({{"material",
                          {{"drucker_prager", {{"phi_d_deg", phi_d}, {"cohesion_Pa", cohesion}}}}}})
                .material);
        for (int n = 0; n < 500; ++n) {
          const double p = n % 5 == 0 ? 0 : std::exp(random.uniform(-5, 5));
          visit(rheology, random_deviator(random) * std::exp(random.uniform(-5, 5)), p);
        }
      }
  }
};
TYPED_TEST_SUITE(RheologyContract, test::AlternativesOf<Rheology>, test::NameByToken);

// Scaling a tensor rounds each component: a few parts in 1e16.
constexpr double rounding = 1e-14;

TYPED_TEST(RheologyContract, YieldedStressLiesInsideTheYieldSurface) {
  this->for_many_stresses([](const auto& rheology, const SymTensor& S, double p) {
    const double Y = rheology.yield_stress(p);
    EXPECT_LE(second_invariant(rheology.yielded(S, p)), Y * Y * (1 + rounding));
  });
}

TYPED_TEST(RheologyContract, YieldNeverLengthensTheDeviator) {
  this->for_many_stresses([](const auto& rheology, const SymTensor& S, double p) {
    EXPECT_LE(contract(rheology.yielded(S, p)), contract(S) * (1 + rounding));
  });
}

TYPED_TEST(RheologyContract, YieldIsIdempotent) {
  this->for_many_stresses([](const auto& rheology, const SymTensor& S, double p) {
    const SymTensor once = rheology.yielded(S, p), twice = rheology.yielded(once, p);
    EXPECT_LE(contract(once + (-1.0) * twice), rounding * rounding * contract(S));
  });
}

TYPED_TEST(RheologyContract, YieldKeepsTheDirectionOfTheDeviator) {
  this->for_many_stresses([](const auto& rheology, const SymTensor& S, double p) {
    const SymTensor yielded = rheology.yielded(S, p);
    const double factor = std::sqrt(contract(yielded) / contract(S));
    EXPECT_LE(contract(yielded + (-factor) * S), rounding * rounding * contract(S));
    EXPECT_NEAR(trace(yielded), 0, rounding * std::sqrt(contract(S)));
  });
}

TYPED_TEST(RheologyContract, StrengthDoesNotFallWithPressure) {
  this->for_many_stresses([](const auto& rheology, const SymTensor&, double p) {
    EXPECT_GE(rheology.yield_stress(2 * p), rheology.yield_stress(p));
    EXPECT_GE(rheology.yield_stress(p), 0);
  });
}

TYPED_TEST(RheologyContract, DamagedMaterialCarriesNoTensionAndAllCompression) {
  this->for_many_stresses([](const auto& rheology, const SymTensor&, double p) {
    EXPECT_EQ(rheology.pressure(-p), 0);
    EXPECT_EQ(rheology.pressure(p), p);
  });
}

}  // namespace
}  // namespace eerie
