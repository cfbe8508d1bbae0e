#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "solver/base/error.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/initial/packing.hpp"
#include "solver/step/solver.hpp"
#include "tests/support/scenes.hpp"

namespace eerie {
namespace {

using testing::HasSubstr;

/// A ball at rest that has not been settled: cheap, and good enough to break.
State ball(const Scene& scene) {
  const auto n = static_cast<std::size_t>(scene.numerics.particles_per_target);
  Random random(1, 0);
  State s;
  resize(s, n);
  s.mass = particle_mass(scene);
  s.h = smoothing_length(scene);
  s.x = packed_sphere("lattice", n, scene.target.radius_m, random);
  for (std::size_t i = 0; i < n; ++i) {
    s.id[i] = static_cast<std::uint32_t>(i);
    s.rho[i] = scene.material.rho0_kg_per_m3;
  }
  return s;
}

/// What stops a run that starts with a spoilt particle, number 123.
template <class Spoil>
NumericalError failure_of(Spoil&& spoil) {
  const Scene scene = test::small_scene();
  State state = ball(scene);
  spoil(state);
  try {
    Solver solver(scene, state);
    for (int cycle = 0; cycle < 10; ++cycle) solver.cycle(1e9);
  } catch (const NumericalError& error) {
    return error;
  }
  return {"nothing stopped it", -1, -1, ""};
}

TEST(Solver, AHealthyStateRunsOn) {
  EXPECT_EQ(failure_of([](State&) {}).kind, "nothing stopped it");
}

TEST(Solver, NegativeDensityStopsWithStepAndParticle) {
  for (const double rho : {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
    const NumericalError error = failure_of([rho](State& s) { s.rho[123] = rho; });
    EXPECT_EQ(error.kind, "negative-density") << rho;
    EXPECT_EQ(error.step, 0);
    EXPECT_EQ(error.particle_id, 123);
    EXPECT_THAT(error.what(), HasSubstr("particle 123"));
    EXPECT_THAT(error.what(), HasSubstr("numerics.cfl"));
  }
}

TEST(Solver, NotANumberStopsTheRunWithinACycle) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expect_stopped = [](const NumericalError& error, const char* what) {
    // A bad number reaches the neighbours in the same step: the particle named is one of them.
    EXPECT_THAT(error.kind, testing::AnyOf("not-finite", "negative-density")) << what;
    EXPECT_GE(error.particle_id, 0) << what;
    EXPECT_LT(error.step, 10) << what;
  };
  expect_stopped(failure_of([](State& s) { s.v[123].y = nan; }), "velocity");
  expect_stopped(failure_of([](State& s) { s.S[123].xy = nan; }), "stress");
  expect_stopped(failure_of([](State& s) { s.v[123].x = 1e300; }), "speed beyond all bounds");
}

TEST(Solver, ACollapseAtTheLargestStepIsAnErrorAndNotAResult) {
  // Squeezed faster than any wave can answer, with the largest step that a scene may ask for.
  const Scene scene = test::small_scene({{"numerics", {{"cfl", 1.5}}}});
  State state = ball(scene);
  for (std::size_t i = 0; i < state.size(); ++i) state.v[i] = -1000.0 * state.x[i];
  try {
    Solver solver(scene, state);
    for (int cycle = 0; cycle < 100; ++cycle) solver.cycle(1e9);
    FAIL() << "ran on";
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.kind, testing::AnyOf("not-finite", "negative-density", "collapse"));
  }
}

}  // namespace
}  // namespace eerie
