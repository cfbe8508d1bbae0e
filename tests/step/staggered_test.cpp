#include <gtest/gtest.h>

#include <cmath>
#include <utility>

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

/// Sound four times slower at the same viscosity, which one stage damps in steps of a quarter of
/// what sound allows.
Scene soft(int stages) {
  Scene scene = thick(1);
  scene.numerics.viscous_stages = stages;
  return scene;
}
constexpr particles::Softening quarter{0.25, false};

TEST(Staggered, StagesOfViscosityLetStepsBeAsLongAsSoundAllows) {
  const auto dt = [](int stages) {
    Solver solver(soft(stages), shaken(soft(stages), quarter));
    solver.cycle(1e9);
    return solver.dt();
  };
  const double h = smoothing_length(soft(1)), c = bulk_sound_speed(soft(1));
  EXPECT_NEAR(dt(1) * c / h, 1.0, 0.01);
  EXPECT_NEAR(dt(2) / dt(1), ChebyshevStages(2).reach(), 0.01);
  EXPECT_NEAR(dt(3) * c / h, 4 * 0.91 * soft(3).numerics.cfl, 0.05);
  EXPECT_EQ(dt(8), dt(3));  // as few as it takes
}

TEST(Staggered, StagesOfViscosityDampTheShortestWavesAndKeepMomentum) {
  for (const int stages : {2, 3}) {
    const Scene scene = soft(stages);
    Solver solver(scene, shaken(scene, quarter));
    const Totals first = totals(scene, solver.state());
    for (int k = 0; k < 3; ++k) solver.cycle(1e9);
    const Totals last = totals(scene, solver.state());
    EXPECT_LT(last.kinetic_energy, 0.5 * first.kinetic_energy) << stages;
    const double speed = std::sqrt(2 * first.kinetic_energy / first.mass);
    EXPECT_LT(norm(last.momentum - first.momentum), 1e-6 * first.mass * speed) << stages;
    EXPECT_LT(norm(last.angular_momentum - first.angular_momentum),
              1e-5 * first.mass * speed * scene.target.radius_m)
        << stages;
  }
}

/// A body that contracts slowly: viscosity brakes it as much in three stages of long steps as in
/// one of short ones.
TEST(Staggered, StagesOfViscosityBrakeAFlowAsShortStepsDo) {
  const auto after = [](int stages, double cfl) {
    Scene scene = soft(stages);
    scene.numerics.cfl = cfl;
    particles::State state = initial::make_impact(scene);
    state.softening = quarter;
    for (std::size_t i = 0; i < state.size(); ++i) state.v[i] = -1e-5 * state.x[i];
    Solver solver(scene, std::move(state));
    const double until = solver.state().time + 20;
    while (solver.state().time < until) solver.cycle(until);
    return totals(scene, solver.state()).kinetic_energy;
  };
  const double exact = after(1, 0.05);
  EXPECT_NEAR(after(3, 1.1) / exact, 1, 0.02);
  EXPECT_NEAR(after(1, 1.1) / exact, 1, 0.02);
}

}  // namespace
}  // namespace eerie::step
