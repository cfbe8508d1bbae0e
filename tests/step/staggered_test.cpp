#include <gtest/gtest.h>

#include <cmath>

#include "solver/base/random.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"
#include "solver/step/totals.hpp"
#include "tests/support/scenes.hpp"

namespace eerie::step {
namespace {

using nlohmann::json;

/// Two balls of a fluid without gravity, so viscous that it and not sound limits the steps.
Scene thick(double alpha) {
  return test::small_scene({{"environment", {{"self_gravity", false}}},
                            {"material", {{"rheology", "fluid"}}},
                            {"numerics",
                             {{"scheme", "closing-gaps"},
                              {"viscosity_alpha", alpha},
                              {"viscosity_particles", 0},
                              {"viscosity_beta", 0}}}});
}

/// At rest but for random velocities: most of their energy is in the shortest waves.
particles::State shaken(const Scene& scene, const particles::Softening& softening) {
  particles::State state = initial::make_impact(scene);
  state.softening = softening;
  Random random(7, 0);
  for (Vec3& v : state.v)
    v = 1e-4 * Vec3{random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5};
  return state;
}

/// Kinetic energy after the first cycles over that of the start.
double left_after(int cycles, const Scene& scene, const particles::Softening& softening) {
  Solver solver(scene, shaken(scene, softening));
  const double first = totals(scene, solver.state()).kinetic_energy;
  for (int k = 0; k < cycles; ++k) solver.cycle(1e9);
  return totals(scene, solver.state()).kinetic_energy / first;
}

TEST(Staggered, StepsAreShortEnoughForViscosityToDampTheShortestWaves) {
  for (const double alpha : {1.0, 2.0, 4.0}) {
    EXPECT_LT(left_after(3, thick(alpha), {}), 0.5) << alpha;
    // Sound four times slower at the same viscosity, which is of first order then.
    EXPECT_LT(left_after(3, thick(alpha / 4), {0.25, false}), 0.5) << alpha;
  }
}

TEST(Staggered, StepsAreAsLongAsViscosityAllows) {
  const Scene scene = thick(4);
  Solver solver(scene, shaken(scene, {}));
  solver.cycle(1e9);
  EXPECT_NEAR(solver.dt(), 0.6 * smoothing_length(scene) / (4 * bulk_sound_speed(scene)),
              0.01 * solver.dt());
}

}  // namespace
}  // namespace eerie::step
