#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/base/constants.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/sph/stress.hpp"
#include "solver/step/solver.hpp"
#include "tests/proof/lab.hpp"
#include "tests/support/scenes.hpp"

namespace eerie::step {
namespace {

TEST(TwoMaterials, YieldEachByItsOwnFrictionAndCohesion) {
  const Scene scene =
      proof::lab_scene({{"material", {{"drucker_prager", {{"phi_d_deg", 50}}}}},
                        {"impactor", {{"material", {{"phi_d_deg", 20}, {"cohesion_Pa", 3}}}}}});
  particles::State state = proof::lattice_block({0, 0, 0}, {8, 8, 8}, 1, 2700);
  for (std::size_t i = 0; i < state.size(); ++i) {
    state.rho[i] = 2700 * 1.001;         // some 27 Pa
    state.S[i] = {0, 0, 0, 1000, 0, 0};  // far more than friction holds
    state.body[i] = state.x[i].x > 4 ? 1 : 0;
  }
  const double slope[] = {std::tan(radians(50)), std::tan(radians(20))}, cohesion[] = {0, 3};
  Solver solver(scene, state);
  solver.cycle(1e-6);  // rates and pressures are then those of the state, to rounding
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (sph::is_frayed(solver.rates().correction[i])) continue;  // the corners
    const std::uint8_t body = solver.state().body[i];
    const double Y = cohesion[body] + slope[body] * solver.pressure()[i];
    EXPECT_NEAR(std::sqrt(second_invariant(solver.state().S[i])), Y, 1e-3 * Y) << i;
  }
}

TEST(TwoMaterials, OfTwoDensitiesAreMadeWithTheirRadii) {
  const Scene scene = test::small_scene({{"impactor", {{"material", {{"rho0_kg_per_m3", 1350}}}}},
                                         {"numerics", {{"particles_per_target", 500}}}});
  const auto extent = [&](particles::Body body) {
    const particles::State s = initial::make_body(scene, body);
    double r2 = 0;
    for (const Vec3& x : s.x) r2 += norm2(x);
    return std::sqrt(5.0 / 3 * r2 / static_cast<double>(s.size()));
  };
  const double target = extent(particles::Body::target),
               impactor = extent(particles::Body::impactor);
  EXPECT_NEAR(target, 50, 2.5);  // edges of particles, and what weight takes
  EXPECT_NEAR(impactor / target, std::cbrt(2.0), 0.02);
}

TEST(TwoMaterials, LeaveTheTargetTheBodyThatItIsAlone) {
  const Scene plain = test::small_scene();
  const Scene two = test::small_scene({{"impactor", {{"material", {{"phi_d_deg", 20}}}}}});
  using particles::Body;
  EXPECT_EQ(initial::body_hash(two, Body::target), initial::body_hash(plain, Body::target));
  EXPECT_NE(initial::body_hash(two, Body::impactor), initial::body_hash(plain, Body::impactor));
  // Where the impactor coheres, no body sees voids.
  const Scene held = test::small_scene({{"impactor", {{"material", {{"cohesion_Pa", 5}}}}}});
  EXPECT_NE(initial::body_hash(held, Body::target), initial::body_hash(plain, Body::target));
}

}  // namespace
}  // namespace eerie::step
