#include <gtest/gtest.h>

#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"
#include "tests/support/scenes.hpp"

namespace eerie::step {
namespace {

/// The reference impact of bodies `k` times as large, at the same speed over the escape speed and
/// over the speed of sound.
Scene scaled(double k) {
  return test::small_scene({{"target", {{"radius_m", 50 * k}}},
                            {"impact", {{"v_imp_cm_per_s", 20 * k}, {"separation", 1.3}}},
                            {"material",
                             {{"shear_modulus_Pa", 22700 * k * k},
                              {"tillotson", {{"A_Pa", 26700 * k * k}, {"B_Pa", 26700 * k * k}}}}}});
}

TEST(Impacts, WithoutCohesionScaleWithTheSizeOfTheBodiesToTheBit) {
  // Gravity, friction and viscosity know no length: all speeds grow as sizes do, times stay. With
  // a power of two every number of the one run is that of the other times a power of two.
  constexpr double k = 16;
  const Scene small_one = scaled(1), large_one = scaled(k);
  Solver one(small_one, initial::make_unsettled_impact(small_one));
  Solver other(large_one, initial::make_unsettled_impact(large_one));
  for (int cycle = 0; cycle < 200; ++cycle) one.cycle(1e9), other.cycle(1e9);
  const particles::State &a = one.state(), &b = other.state();
  ASSERT_EQ(a.size(), b.size());
  EXPECT_GT(a.time, 300) << "they have not met yet";
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.step, b.step);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(k * a.x[i], b.x[i]) << i;
    EXPECT_EQ(k * a.v[i], b.v[i]) << i;
    EXPECT_EQ(a.rho[i], b.rho[i]) << i;
  }
}

}  // namespace
}  // namespace eerie::step
