#include <gtest/gtest.h>

#include <cmath>

#include "solver/material/material.hpp"
#include "tests/support/particles.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/variant_types.hpp"

namespace eerie::material {
namespace {

using test::random_deviator;
using test::small_scene;

/// What every rheology owes to the solver, in every condition of the material.
template <class Rheology>
class RheologyContract : public testing::Test {
 protected:
  /// Calls visit(rheology, S, p, condition) for many stresses on both sides of the yield surface.
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
          // Rocks yield at ten megapascals: stresses up to a gigapascal.
          const double scale = n % 2 == 0 ? 1 : 1e7;
          const Condition condition{n % 3 == 0 ? 0 : random.uniform(0, 4e6),
                                    n % 4 == 0 ? 1 : random.uniform()};
          visit(rheology, random_deviator(random) * (scale * std::exp(random.uniform(-5, 5))),
                scale * p, condition);
        }
      }
  }
};
TYPED_TEST_SUITE(RheologyContract, test::AlternativesOf<Rheology>, test::NameByToken);

// Scaling a tensor rounds each component: a few parts in 1e16.
constexpr double rounding = 1e-14;

TYPED_TEST(RheologyContract, YieldedStressLiesInsideTheYieldSurface) {
  this->for_many_stresses(
      [](const auto& rheology, const SymTensor& S, double p, const Condition& state) {
        const double Y = rheology.yield_stress(p, state);
        EXPECT_LE(second_invariant(yielded(rheology, S, p, state)), Y * Y * (1 + rounding));
      });
}

TYPED_TEST(RheologyContract, YieldNeverLengthensTheDeviator) {
  this->for_many_stresses(
      [](const auto& rheology, const SymTensor& S, double p, const Condition& state) {
        EXPECT_LE(contract(yielded(rheology, S, p, state)), contract(S) * (1 + rounding));
      });
}

TYPED_TEST(RheologyContract, YieldIsIdempotent) {
  this->for_many_stresses(
      [](const auto& rheology, const SymTensor& S, double p, const Condition& state) {
        const SymTensor once = yielded(rheology, S, p, state),
                        twice = yielded(rheology, once, p, state);
        EXPECT_LE(contract(once + (-1.0) * twice), rounding * rounding * contract(S));
      });
}

TYPED_TEST(RheologyContract, YieldKeepsTheDirectionOfTheDeviator) {
  this->for_many_stresses(
      [](const auto& rheology, const SymTensor& S, double p, const Condition& state) {
        const SymTensor returned = yielded(rheology, S, p, state);
        const double factor = std::sqrt(contract(returned) / contract(S));
        EXPECT_LE(contract(returned + (-factor) * S), rounding * rounding * contract(S));
        EXPECT_NEAR(trace(returned), 0, rounding * std::sqrt(contract(S)));
      });
}

TYPED_TEST(RheologyContract, StrengthDoesNotFallWithPressure) {
  this->for_many_stresses(
      [](const auto& rheology, const SymTensor&, double p, const Condition& state) {
        EXPECT_GE(rheology.yield_stress(2 * p, state), rheology.yield_stress(p, state));
        EXPECT_GE(rheology.yield_stress(p, state), 0);
      });
}

TYPED_TEST(RheologyContract, CompressionIsCarriedWholeAndTensionByWhatIsIntact) {
  this->for_many_stresses(
      [](const auto& rheology, const SymTensor&, double p, const Condition& state) {
        EXPECT_EQ(rheology.pressure(p, state), p);
        EXPECT_LE(rheology.pressure(-p, state), 0);
        EXPECT_GE(rheology.pressure(-p, state), -p);
        // Rubble has no tensile strength; what never breaks keeps all of it.
        const bool unbreakable = std::isinf(rheology.yield_stress(p, state));
        EXPECT_EQ(rheology.pressure(-p, {state.u, 1}), unbreakable ? -p : 0);
      });
}

TYPED_TEST(RheologyContract, DamageAndHeatNeverStrengthen) {
  this->for_many_stresses(
      [](const auto& rheology, const SymTensor&, double p, const Condition& state) {
        const double Y = rheology.yield_stress(p, state);
        EXPECT_LE(rheology.yield_stress(p, {state.u, std::min(1.0, state.damage + 0.1)}),
                  Y * (1 + rounding));
        EXPECT_LE(rheology.yield_stress(p, {state.u + 1e5, state.damage}), Y * (1 + rounding));
      });
}

}  // namespace
}  // namespace eerie::material
