#include "analysis/flight/flight.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "analysis/remnants/orbit.hpp"
#include "solver/base/constants.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"
#include "tests/analysis/remnants/bodies.hpp"
#include "tests/support/scenes.hpp"

namespace eerie::flight {
namespace {

using test::add_body;
using test::empty_state;
using test::particle_mass_kg;
using test::spacing;

FlightPlan plan_until(double time) {
  FlightPlan plan;
  plan.until_s = time;
  plan.spacing = spacing;
  plan.heavy = 50 * particle_mass_kg;
  plan.most_landed = std::numeric_limits<double>::infinity();
  return plan;
}

remnants::PointMass centre(const particles::State& state, particles::Body body) {
  remnants::PointMass sum;
  for (std::size_t i = 0; i < state.size(); ++i)
    if (state.body[i] == static_cast<std::uint8_t>(body))
      sum.mass += state.mass, sum.x += state.x[i], sum.v += state.v[i];
  const double n = sum.mass / state.mass;
  return {sum.mass, sum.x / n, sum.v / n};
}

remnants::Orbit orbit_of(const particles::State& state) {
  return remnants::relative_orbit(centre(state, particles::Body::target),
                                  centre(state, particles::Body::impactor));
}

struct Sums {
  Vec3 momentum, L;
};
Sums sums(const particles::State& state) {
  Sums s;
  for (std::size_t i = 0; i < state.size(); ++i)
    s.momentum += state.mass * state.v[i], s.L += state.mass * cross(state.x[i], state.v[i]);
  return s;
}

double least_distance(const particles::State& state, particles::Body one, particles::Body other) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < state.size(); ++i)
    for (std::size_t j = 0; j < state.size(); ++j)
      if (state.body[i] == static_cast<std::uint8_t>(one) &&
          state.body[j] == static_cast<std::uint8_t>(other) && i != j)
        least = std::min(least, norm(state.x[i] - state.x[j]));
  return least;
}

/// Two balls of 30 m, so far apart, with a tenth of the speed of a circular orbit across.
particles::State falling_balls(double apart, double across = 0.1) {
  particles::State state = empty_state();
  add_body(state, {30, 30, 30}, {}, {}, particles::Body::target);
  const double mass = 2 * state.mass * static_cast<double>(state.size());
  const double v = across * std::sqrt(newton_G * mass / apart);
  for (Vec3& u : state.v) u = {0, -v / 2, 0};
  add_body(state, {30, 30, 30}, {apart, 0, 0}, {0, v / 2, 0}, particles::Body::impactor);
  return state;
}

TEST(Flight, FollowsTheOrbitOfTwoBodies) {
  const particles::State start = falling_balls(300, 0.8);
  const remnants::Orbit before = orbit_of(start);
  const double a = -before.mu / (2 * before.specific_energy);
  const double period = 2 * pi * std::sqrt(cubed(a) / before.mu);
  FlightPlan plan = plan_until(period);
  plan.opening_angle = 0.1;
  const Flight flight = fly(start, plan);
  EXPECT_EQ(flight.end, FlightEnd::time);
  EXPECT_DOUBLE_EQ(flight.state.time, period);
  const remnants::Orbit after = orbit_of(flight.state);
  EXPECT_NEAR(after.specific_energy / before.specific_energy, 1, 1e-4);
  EXPECT_NEAR(after.eccentricity, before.eccentricity, 1e-3);
  const Vec3 apart = centre(flight.state, particles::Body::impactor).x -
                     centre(flight.state, particles::Body::target).x;
  EXPECT_LT(norm(apart - Vec3{300, 0, 0}), 6);  // of a way of 1,800 m
}

TEST(Flight, KeepsMomentumAndAngularMomentum) {
  const particles::State start = falling_balls(300, 0.8);
  const Flight flight = fly(start, plan_until(3e4));
  const Sums before = sums(start), after = sums(flight.state);
  EXPECT_LT(norm(after.L - before.L), 1e-10 * norm(before.L));
  EXPECT_LT(norm(after.momentum - before.momentum), 1e-10 * norm(before.L) / 300);
}

/// A long body that turns slowly.
particles::State long_body() {
  particles::State state = empty_state();
  const std::vector<Vec3> x = test::ellipsoid({70, 30, 20}, spacing);
  test::add(state, x, test::spinning(x, {3e-6, 0, 1e-5}, {}), particles::Body::target);
  return state;
}

// The tree's forces between particles of one body do not sum to zero; no body may fly by itself.
TEST(Flight, LeavesALoneBodyWhereItIs) {
  const particles::State start = long_body();
  const particles::State end = fly(start, plan_until(3e5)).state;
  EXPECT_LT(norm(centre(end, particles::Body::target).x - centre(start, particles::Body::target).x),
            1e-6);
  EXPECT_LT(norm(sums(end).L - sums(start).L), 1e-9 * norm(sums(start).L));
}

TEST(Flight, KeepsTheAngularMomentumOfBodiesThatPartByKilometres) {
  particles::State start = long_body();
  add_body(start, {30, 30, 30}, {300, 0, 0}, {0.1, 0.01, 0}, particles::Body::impactor);
  const particles::State end = fly(start, plan_until(3e5)).state;
  EXPECT_GT(norm(centre(end, particles::Body::impactor).x), 1e4);
  EXPECT_LT(norm(sums(end).L - sums(start).L), 1e-9 * norm(sums(start).L));
}

TEST(Flight, KeepsMomentumAndAngularMomentumOfDebrisAlone) {
  // Lone particles on a lattice that turns; each is light and lands nowhere.
  particles::State start = empty_state();
  std::vector<Vec3> x;
  for (int i = 0; i < 343; ++i)
    x.push_back({40.0 * (i % 7), 50.0 * (i / 7 % 7) + (i % 3), 60.0 * (i / 49) + (i % 5)});
  test::add(start, x, test::spinning(x, {0, 0, 2e-5}, {}), particles::Body::target);
  const Flight flight = fly(start, plan_until(2e4));
  EXPECT_EQ(flight.end, FlightEnd::time);
  EXPECT_GT(norm(flight.state.v[0] - start.v[0]), 1e-3 * norm(start.v[0])) << "they pull";
  const Sums before = sums(start), after = sums(flight.state);
  EXPECT_LT(norm(after.L - before.L), 1e-10 * norm(before.L));
  EXPECT_LT(norm(after.momentum - before.momentum), 1e-10 * norm(before.L) / 300);
}

TEST(Flight, EndsBeforeHeavyBodiesTouch) {
  const particles::State start = falling_balls(300);
  const double contact = 60 + 3 * start.h;
  const double expected = remnants::time_to_reach(orbit_of(start), contact);
  const Flight flight = fly(start, plan_until(1e6));
  EXPECT_EQ(flight.end, FlightEnd::encounter);
  EXPECT_NEAR(flight.state.time, expected, 100);
  EXPECT_GT(least_distance(flight.state, particles::Body::target, particles::Body::impactor),
            start.h);
  EXPECT_EQ(flight.landed, 0);
}

/// A ball that turns, and a particle that falls on it.
particles::State ball_and_particle() {
  particles::State state = empty_state();
  const std::vector<Vec3> x = test::ellipsoid({40, 30, 30}, spacing);
  test::add(state, x, test::spinning(x, {0, 0, 2e-4}, {}), particles::Body::target);
  test::add(state, {{0, 60, 1}}, {{0.01, -0.01, 0}}, particles::Body::impactor);
  return state;
}

TEST(Flight, LetsLightBodiesLand) {
  const particles::State start = ball_and_particle();
  const Flight flight = fly(start, plan_until(1e4));
  EXPECT_EQ(flight.end, FlightEnd::time);
  EXPECT_DOUBLE_EQ(flight.landed, start.mass);
  const double distance =
      least_distance(flight.state, particles::Body::impactor, particles::Body::target);
  EXPECT_LT(distance, 1.2 * spacing);
  EXPECT_GT(distance, 0.9 * spacing);
  const Sums before = sums(start), after = sums(flight.state);
  EXPECT_LT(norm(after.L - before.L), 1e-3 * norm(before.L));
}

TEST(Flight, EndsOnceSoMuchHasLanded) {
  FlightPlan plan = plan_until(1e4);
  plan.most_landed = 0.5 * particle_mass_kg;
  const Flight flight = fly(ball_and_particle(), plan);
  EXPECT_EQ(flight.end, FlightEnd::landed);
  EXPECT_LT(flight.state.time, 5e3);
}

TEST(Flight, EndsOnceNothingIsWaitedForOrItIsToldTo) {
  FlightPlan plan = plan_until(1e5);
  plan.waits = [](const particles::State& s) { return s.time < 2e3; };
  const Flight bored = fly(falling_balls(300, 0.8), plan);
  EXPECT_EQ(bored.end, FlightEnd::nothing_left);
  EXPECT_GE(bored.state.time, 2e3);
  plan.stop = [] { return true; };
  const Flight stopped = fly(falling_balls(300, 0.8), plan);
  EXPECT_EQ(stopped.end, FlightEnd::stopped);
  EXPECT_EQ(stopped.steps, 0);
}

TEST(Flight, DoesNotDependOnTheMemoryOrder) {
  const particles::State start = ball_and_particle(), other = test::shuffled(start, 3);
  const particles::State one = fly(start, plan_until(3e3)).state,
                         two = fly(other, plan_until(3e3)).state;
  for (std::size_t k = 0; k < two.size(); ++k) {
    const auto i = static_cast<std::size_t>(two.id[k]);
    EXPECT_LT(norm(two.x[k] - one.x[i]), 1e-6);
    EXPECT_LT(norm(two.v[k] - one.v[i]), 1e-9);
  }
}

// The same approach as matter: what a flight stands in for.
TEST(Flight, BringsBodiesToTheirImpactAsMatterDoes) {
  const Scene scene = test::small_scene({{"impact", {{"separation", 3}}}});
  const particles::State start = initial::make_impact(scene);
  FlightPlan plan = plan_until(1e5);
  plan.spacing = std::cbrt(start.mass / scene.material.rho0_kg_per_m3);
  plan.heavy = 100 * start.mass;
  const Flight flight = fly(start, plan);
  ASSERT_EQ(flight.end, FlightEnd::encounter);
  ASSERT_GT(flight.state.time, 400);
  step::Solver matter(scene, start);
  while (matter.state().time < flight.state.time) matter.cycle(flight.state.time);
  for (const particles::Body body : {particles::Body::target, particles::Body::impactor}) {
    const remnants::PointMass flown = centre(flight.state, body),
                              computed = centre(matter.state(), body);
    EXPECT_LT(norm(flown.x - computed.x), 0.05);  // m, of 50
    EXPECT_LT(norm(flown.v - computed.v), 1e-4);  // m/s, of 0.1
  }
}

}  // namespace
}  // namespace eerie::flight
