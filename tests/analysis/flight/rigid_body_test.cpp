#include "analysis/flight/rigid_body.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "solver/base/constants.hpp"
#include "tests/analysis/remnants/bodies.hpp"

namespace eerie::flight {
namespace {

using test::spacing;
using test::spinning;

/// One body of the given half axes, turning with `omega` and moving with `v`.
particles::State spinning_body(const Vec3& half, const Vec3& omega, const Vec3& v = {}) {
  particles::State state = test::empty_state();
  const std::vector<Vec3> x =
      test::moved(test::ellipsoid(half, spacing), test::rotation({1, 2, 3}, 0.7), {30, -20, 10});
  test::add(state, x, spinning(x, omega, v), particles::Body::target);
  return state;
}

remnants::Clump everything(const particles::State& state) {
  remnants::Clump all(state.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

RigidBody body_of(const particles::State& state) { return rigid_body(state, everything(state)); }

struct Sums {
  Vec3 momentum, L;
};
Sums sums(const particles::State& state) {
  Sums s;
  for (std::size_t i = 0; i < state.size(); ++i)
    s.momentum += state.mass * state.v[i], s.L += state.mass * cross(state.x[i], state.v[i]);
  return s;
}

double spin_energy(const RigidBody& body) { return dot(body.angular_velocity(), body.L) / 2; }

double drift_of_energy(const RigidBody& start, double duration, int steps) {
  RigidBody body = start;
  for (int k = 0; k < steps; ++k) body.drift(duration / steps);
  return std::abs(spin_energy(body) / spin_energy(start) - 1);
}

TEST(RigidBody, HasTheSpinOfItsParticles) {
  const Vec3 omega{1e-4, -3e-4, 2e-4};
  const RigidBody body = body_of(spinning_body({60, 30, 20}, omega));
  EXPECT_LT(norm(body.angular_velocity() - omega), 1e-9 * norm(omega));
}

TEST(RigidBody, OfAStateThatMovesRigidlyIsPutBackAsItWas) {
  const particles::State before = spinning_body({60, 30, 20}, {1e-4, -3e-4, 2e-4}, {0.1, 0, -0.2});
  particles::State after = before;
  put_back(body_of(before), after);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_LT(norm(after.x[i] - before.x[i]), 1e-12);
    EXPECT_LT(norm(after.v[i] - before.v[i]), 1e-11);
  }
}

// A free symmetric top: its axis goes round L at the rate L/I, I across the axis (Landau &
// Lifshitz, Mechanics, sec. 33).
TEST(RigidBody, PrecessesAsAFreeSymmetricTop) {
  const Vec3 axis = test::rotation({1, 2, 3}, 0.7) * Vec3{1, 0, 0};
  const RigidBody start = body_of(spinning_body({60, 20, 20}, 3e-4 * axis + Vec3{1e-4, 2e-4, 0}));
  const SymTensor& I = start.inertia;
  const double along = dot(axis, to_matrix(I) * axis), across = (trace(I) - along) / 2;
  const double rate = norm(start.L) / across;
  const double turns = 3 + 1.0 / 3;
  RigidBody body = start;
  const int steps = 3000;
  for (int k = 0; k < steps; ++k) body.drift(turns * 2 * pi / rate / steps);
  const Vec3 expected = test::rotation(start.L, 2 * pi / 3) * axis;
  EXPECT_LT(norm(body.turned * axis - expected), 1e-3);
  EXPECT_GT(norm(axis - expected), 0.1);
}

TEST(RigidBody, ThatTumblesKeepsItsEnergyToSecondOrder) {
  // About its middle axis, where a free rotation is unstable.
  const Vec3 middle = test::rotation({1, 2, 3}, 0.7) * Vec3{0, 1, 0};
  const RigidBody body =
      body_of(spinning_body({60, 40, 20}, 3e-4 * middle + Vec3{1e-6, 1e-6, 1e-6}));
  const double coarse = drift_of_energy(body, 1e5, 500), fine = drift_of_energy(body, 1e5, 1000);
  EXPECT_LT(fine, 1e-3);
  EXPECT_LT(fine, coarse / 3);
}

/// A large body and a small one beside it, both stressed.
struct Pair {
  particles::State state = spinning_body({30, 20, 20}, {1e-4, 2e-4, 0}, {0.05, 0, 0});
  remnants::Clump large = everything(state), small;
  Pair() {
    const std::vector<Vec3> x =
        test::moved(test::ellipsoid({20, 20, 10}, spacing), Mat3::identity(), {80, -20, 10});
    test::add(state, x, spinning(x, {0, 0, -4e-4}, {-0.1, 0.02, 0}), particles::Body::impactor);
    for (auto i = static_cast<std::uint32_t>(large.size()); i < state.size(); ++i)
      small.push_back(i);
    for (std::size_t i = 0; i < state.size(); ++i)
      state.S[i] = {2, -1, -1, 0.1 * static_cast<double>(i % 7), 0, 0.3};
  }
};

TEST(RigidBody, StuckToAnotherKeepsMassMomentumAndAngularMomentum) {
  Pair pair;
  particles::State& state = pair.state;
  const Sums before = sums(state);
  const RigidBody both =
      stuck_together(rigid_body(state, pair.large), rigid_body(state, pair.small), state);
  put_back(both, state);
  const Sums after = sums(state);
  EXPECT_EQ(both.members.size(), state.size());
  EXPECT_LT(norm(after.momentum - before.momentum), 1e-11 * norm(before.momentum));
  EXPECT_LT(norm(after.L - before.L), 1e-8 * norm(before.L));
}

TEST(RigidBody, StuckToAnotherAfterBothHaveTurnedLeavesEveryParticleWhereItWas) {
  Pair pair;
  for (const bool large_first : {true, false}) {
    RigidBody large = rigid_body(pair.state, pair.large),
              small = rigid_body(pair.state, pair.small);
    large.drift(3000), small.drift(2000);
    particles::State apart = pair.state, together = pair.state;
    put_back(large, apart), put_back(small, apart);
    const RigidBody both = large_first ? stuck_together(large, small, together)
                                       : stuck_together(small, large, together);
    put_back(both, together);
    for (std::size_t i = 0; i < apart.size(); ++i) {
      EXPECT_LT(norm(together.x[i] - apart.x[i]), 1e-10);
      const Vec3 across{1, 2, 3};
      EXPECT_LT(norm(to_matrix(together.S[i]) * across - to_matrix(apart.S[i]) * across), 1e-12);
    }
  }
}

/// As `touch` should say, pair by pair.
bool any_within(const RigidBody& one, const RigidBody& other, double contact) {
  for (std::size_t k = 0; k < one.offsets.size(); ++k)
    for (std::size_t l = 0; l < other.offsets.size(); ++l)
      if (norm(one.place(k) - other.place(l)) < contact) return true;
  return false;
}

TEST(RigidBody, TouchesAnotherWhereverOneOfItsParticlesIsWithinContact) {
  Pair pair;
  RigidBody large = rigid_body(pair.state, pair.large), small = rigid_body(pair.state, pair.small);
  large.drift(1000);
  int touching = 0;
  const int places = 400;
  for (int k = 0; k < places; ++k) {
    small.x = large.x + (36 + 0.03 * k) * (test::rotation({1, 2, 3}, 0.1 * k) * Vec3{1, 0, 0});
    small.drift(100);
    const bool expected = any_within(large, small, spacing);
    EXPECT_EQ(touch(large, small, spacing), expected);
    EXPECT_EQ(touch(small, large, spacing), expected);
    touching += expected;
  }
  EXPECT_GT(touching, places / 8);
  EXPECT_LT(touching, places * 7 / 8);
}

TEST(RigidBody, OfOneOrTwoParticlesHasItsAngularMomentum) {
  particles::State state = test::empty_state();
  test::add(state, {{0, 0, 0}, {6, 0, 0}}, {{0, 0, 0.01}, {0, 0.02, -0.01}},
            particles::Body::target);
  const Sums before = sums(state);
  RigidBody pair = body_of(state);
  pair.drift(100);
  put_back(pair, state);
  EXPECT_LT(norm(sums(state).L - before.L), 1e-8 * norm(before.L));
  const RigidBody single = rigid_body(state, {1});
  EXPECT_EQ(norm(single.angular_velocity()), 0);
}

TEST(RigidBody, TurnsTheStressOfItsParticlesWithIt) {
  particles::State state = spinning_body({30, 20, 20}, {0, 0, 1e-3});
  for (SymTensor& S : state.S) S = {2, -1, -1, 0, 0, 0};  // pulled along x
  RigidBody body = body_of(state);
  const int steps = 2000;
  for (int k = 0; k < steps; ++k) body.drift(pi / 2 / 1e-3 / steps);  // x becomes y, about
  put_back(body, state);
  const Vec3 pulled = body.turned * Vec3{1, 0, 0};
  for (const SymTensor& S : state.S) {
    EXPECT_NEAR(dot(pulled, to_matrix(S) * pulled), 2, 1e-9);
    EXPECT_NEAR(second_invariant(S), 3, 1e-9);
  }
  EXPECT_LT(std::abs(pulled.x), 0.7);
}

}  // namespace
}  // namespace eerie::flight
