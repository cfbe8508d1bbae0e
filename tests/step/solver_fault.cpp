#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/base/error.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/initial/packing.hpp"
#include "solver/step/solver.hpp"
#include "tests/support/scenes.hpp"

namespace eerie::step {
namespace {

using testing::HasSubstr;

/// A ball at rest that has not been settled: cheap, and good enough to break.
particles::State ball(const Scene& scene) {
  const auto n = static_cast<std::size_t>(scene.numerics.particles_per_target);
  Random random(1, 0);
  particles::State s;
  particles::resize(s, n);
  s.mass = particle_mass(scene);
  s.h = smoothing_length(scene);
  s.x = initial::packed_sphere("lattice", n, scene.target.radius_m, random);
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
  particles::State state = ball(scene);
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
  EXPECT_EQ(failure_of([](particles::State&) {}).kind, "nothing stopped it");
}

TEST(Solver, NegativeDensityStopsWithStepAndParticle) {
  for (const double rho : {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
    const NumericalError error = failure_of([rho](particles::State& s) { s.rho[123] = rho; });
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
    EXPECT_THAT(error.kind, testing::AnyOf("not-finite", "negative-density", "singular-matrix"))
        << what;
    EXPECT_GE(error.particle_id, 0) << what;
    EXPECT_LT(error.step, 10) << what;
  };
  expect_stopped(failure_of([](particles::State& s) { s.v[123].y = nan; }), "velocity");
  expect_stopped(failure_of([](particles::State& s) { s.S[123].xy = nan; }), "stress");
  expect_stopped(failure_of([](particles::State& s) { s.v[123].x = 1e300; }),
                 "speed beyond all bounds");
}

TEST(Solver, ACollapseAtTheLargestStepIsAnErrorAndNotAResult) {
  // Squeezed faster than any wave can answer, with the largest step that a scene may ask for.
  const Scene scene =
      test::small_scene({{"numerics", {{"scheme", "libersky-petschek-2018"}, {"cfl", 1.5}}}});
  particles::State state = ball(scene);
  for (std::size_t i = 0; i < state.size(); ++i) state.v[i] = -1000.0 * state.x[i];
  try {
    Solver solver(scene, state);
    for (int cycle = 0; cycle < 100; ++cycle) solver.cycle(1e9);
    FAIL() << "ran on";
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.kind, testing::AnyOf("not-finite", "negative-density", "collapse",
                                           "singular-matrix", "lost-particle"));
  }
}

TEST(Solver, AParticleThrownOffForNoReasonIsCalledLost) {
  // The bodies bring centimetres per second; a fast one may be real at the start of a run, so
  // this one is poisoned while it runs, as a faulty force would.
  const Scene scene = test::small_scene();
  Solver healthy(scene, ball(scene));
  healthy.cycle(1e9);
  particles::Rates rates = healthy.rates();
  rates.g[17] = Vec3f({1e4, 0, 0});
  Solver poisoned(scene, healthy.state(), rates, healthy.restart(), healthy.pressure());
  try {
    for (int cycle = 0; cycle < 100; ++cycle) poisoned.cycle(1e9);
    FAIL() << "ran on";
  } catch (const NumericalError& error) {
    EXPECT_EQ(error.kind, "lost-particle");
    EXPECT_EQ(error.particle_id, static_cast<long>(healthy.state().id[17]));
    EXPECT_GT(error.step, 0);
    EXPECT_THAT(error.what(), HasSubstr("further away"));
  }
}

TEST(Solver, AFewLooseGrainsInAPlaneAreNoCollapse) {
  // Debris of an impact: five neighbours, expanded to a fifth of the density and more, seem to fill
  // the surroundings of a dense grain. Four more are listed and out of reach.
  struct Grain {
    Vec3 x;  ///< smoothing lengths
    double rho;
  };
  const std::vector<Grain> grains = {{{0, 0, 0}, 2700},
                                     {{-0.27, -0.54, 0.29}, 569},
                                     {{0.47, 0.54, -0.48}, 1292},
                                     {{-0.86, 0.11, 0.70}, 526},
                                     {{0.90, -0.60, -0.41}, 418},
                                     {{-1.73, 0.55, 0.51}, 738},
                                     {{-2.13, -0.05, -0.65}, 2701},
                                     {{-2.09, 0.78, -0.22}, 1387},
                                     {{-1.47, -1.60, -0.79}, 1079},
                                     {{-2.16, -0.33, -0.60}, 2701}};
  for (const double skin : {0.0, 0.1, 0.15, 0.4}) {
    const Scene scene = test::small_scene({{"numerics", {{"list_skin", skin}}}});
    particles::State state = ball(scene);
    particles::resize(state, grains.size());
    for (std::size_t i = 0; i < grains.size(); ++i)
      state.x[i] = state.h * grains[i].x, state.rho[i] = grains[i].rho;
    EXPECT_NO_THROW(Solver(scene, state)) << skin;
  }
}

TEST(Solver, NeighboursPressedIntoAPlaneAreASingularMatrix) {
  const NumericalError error = failure_of([](particles::State& s) {
    // A whole ball flattened to a sheet: full neighbourhoods without any depth.
    for (Vec3& x : s.x) x.z *= 1e-4;
  });
  EXPECT_EQ(error.kind, "singular-matrix");
  EXPECT_EQ(error.step, 0);
  EXPECT_GE(error.particle_id, 0);
  EXPECT_THAT(error.what(), HasSubstr("plane"));
}

TEST(Solver, AFlatClumpOfAFewLooseParticlesIsNoCollapse) {
  // A dense particle and what is left around it, in units of h, far from everything else.
  const Scene scene = test::small_scene();
  particles::State state = ball(scene);
  const Vec3 places[] = {{}, {0.8, 0.01, 0}, {0.1, 0.9, 0}, {-0.6, -0.5, 0.01}, {0.7, 0.8, 0}};
  const double densities[] = {2600, 400, 450, 500, 600};
  for (std::size_t k = 0; k < 5; ++k) {
    state.x[k] = Vec3{1000, 0, 0} + state.h * places[k];
    state.v[k] = {};
    state.rho[k] = densities[k];
  }
  Solver solver(scene, state);
  EXPECT_NO_THROW(solver.cycle(1e9));
}

TEST(Solver, LooseParticlesGoUncorrectedAndAreCounted) {
  const Scene scene = test::small_scene();
  particles::State state = ball(scene);
  state.x[5] += Vec3{400, 0, 0};  // alone
  Solver solver(scene, state);
  solver.cycle(1e9);
  EXPECT_EQ(solver.uncorrected(), 1);
}

TEST(Solver, AParticleBeyondAWallStopsTheRun) {
  const Scene scene =
      test::small_scene({{"environment", {{"walls", {{{"face", "z_low"}, {"at_m", -20}}}}}}});
  Solver solver(scene, ball(scene));
  try {
    solver.cycle(1e9);
    FAIL() << "ran on";
  } catch (const NumericalError& error) {
    EXPECT_EQ(error.kind, "through-wall");
    EXPECT_THAT(error.what(), HasSubstr("viscosity_beta"));
  }
}

TEST(Solver, GasColderThanNothingHasNoSoundSpeed) {
  const Scene scene = test::small_scene(
      {{"material", {{"eos", "ideal-gas"}, {"energy", "integrated"}, {"rheology", "fluid"}}}});
  particles::State state = ball(scene);
  particles::resize(state, state.size(), {.energy = true});
  std::fill(state.u.begin(), state.u.end(), 1.0);
  state.u[123] = -1;
  try {
    Solver solver(scene, state);
    FAIL() << "ran on";
  } catch (const NumericalError& error) {
    EXPECT_EQ(error.kind, "no-sound-speed");
    EXPECT_EQ(error.particle_id, 123);
  }
}

TEST(Solver, WallsCloserThanAParticleReachesAreRefused) {
  const Scene scene = test::small_scene(
      {{"environment",
        {{"walls", {{{"face", "y_low"}, {"at_m", -1}}, {{"face", "y_high"}, {"at_m", 1}}}}}}});
  EXPECT_THROW(Solver(scene, ball(scene)), InputError);
}

}  // namespace
}  // namespace eerie::step
