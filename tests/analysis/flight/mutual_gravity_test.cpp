#include "analysis/flight/mutual_gravity.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "solver/base/constants.hpp"
#include "tests/analysis/remnants/bodies.hpp"

namespace eerie::flight {
namespace {

using test::add;
using test::add_body;
using test::particle_mass_kg;
using test::spacing;

/// Two large bodies that have turned, one of them long, a small one and two particles.
struct Scattered {
  particles::State state = test::empty_state();
  std::vector<RigidBody> bodies;

  Scattered() {
    const auto turn_last = [&](const Vec3& axis, double angle) {
      bodies.back().turned = test::rotation(axis, angle);
    };
    take_in([&] { add_body(state, {70, 30, 20}, {}, {}, particles::Body::target); });
    turn_last({1, 2, 3}, 0.7);
    take_in([&] { add_body(state, {30, 25, 30}, {120, 30, -10}, {}, particles::Body::impactor); });
    turn_last({0, 1, 1}, 2);
    take_in([&] { add_body(state, {8, 8, 8}, {50, -60, 20}, {}, particles::Body::impactor); });
    turn_last({1, 0, 0}, 1);
    for (const Vec3& x : {Vec3{200, 0, 0}, Vec3{-90, 40, 60}})
      take_in([&] { add(state, {x}, {Vec3{}}, particles::Body::impactor); });
  }

 private:
  template <class Add>
  void take_in(Add&& add_particles) {
    remnants::Clump members;
    const std::size_t first = state.size();
    add_particles();
    for (std::size_t i = first; i < state.size(); ++i)
      members.push_back(static_cast<std::uint32_t>(i));
    bodies.push_back(rigid_body(state, std::move(members)));
  }
};

constexpr double heavy = 50 * particle_mass_kg;

std::vector<Pull> pulls_by_tree(Scattered scattered, double opening_angle) {
  MutualGravity gravity({particle_mass_kg, scattered.state.h, opening_angle}, heavy);
  gravity.take(scattered.bodies, scattered.state.id);
  return gravity.pulls(scattered.bodies);
}

/// Newton's law between the particles of different bodies: all of these are beyond the softening.
std::vector<Pull> pulls_by_pairs(const std::vector<RigidBody>& bodies) {
  std::vector<Pull> pulls(bodies.size());
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (std::size_t b = 0; b < bodies.size(); ++b)
      for (std::size_t k = 0; a != b && k < bodies[a].offsets.size(); ++k)
        for (std::size_t l = 0; l < bodies[b].offsets.size(); ++l) {
          const Vec3 x = bodies[a].place(k), d = bodies[b].place(l) - x;
          const Vec3 force =
              (newton_G * particle_mass_kg * particle_mass_kg / std::pow(norm(d), 3)) * d;
          pulls[a].force += force;
          pulls[a].torque += cross(x - bodies[a].x, force);
        }
  return pulls;
}

void expect_near(const std::vector<Pull>& pulls, const std::vector<Pull>& exact, double part) {
  ASSERT_EQ(pulls.size(), exact.size());
  for (std::size_t b = 0; b < exact.size(); ++b) {
    EXPECT_LT(norm(pulls[b].force - exact[b].force), part * norm(exact[b].force)) << b;
    // Torques are what differences over a body leave of its weight.
    EXPECT_LT(norm(pulls[b].torque - exact[b].torque), part * spacing * norm(exact[b].force)) << b;
  }
}

TEST(MutualGravity, IsTheSumOverPairsOfParticlesOfDifferentBodies) {
  const Scattered scattered;
  const std::vector<Pull> exact = pulls_by_pairs(scattered.bodies);
  ASSERT_GT(norm(exact[0].torque), spacing * norm(exact[0].force) / 10);
  expect_near(pulls_by_tree(scattered, 0), exact, 1e-5);  // rounding of single precision
  expect_near(pulls_by_tree(scattered, 0.35), exact, 2e-3);
}

TEST(MutualGravity, OfHeavyBodiesAndOneLightOneLeavesMomentumAndAngularMomentumAlone) {
  Scattered scattered;
  scattered.bodies.resize(3);
  for (const double opening_angle : {0.35, 0.8}) {
    const std::vector<Pull> pulls = pulls_by_tree(scattered, opening_angle);
    Vec3 force, torque;
    for (std::size_t b = 0; b < pulls.size(); ++b) {
      force += pulls[b].force;
      torque += pulls[b].torque + cross(scattered.bodies[b].x, pulls[b].force);
    }
    // The light one's particles attract each other as well: to rounding of single precision.
    EXPECT_LT(norm(force), 1e-7 * norm(pulls[0].force));
    EXPECT_LT(norm(torque), 1e-7 * 100 * norm(pulls[0].force));
  }
}

TEST(MutualGravity, OfABodyAloneIsNone) {
  Scattered scattered;
  scattered.bodies.resize(1);
  const std::vector<Pull> pulls = pulls_by_tree(scattered, 0.35);
  EXPECT_EQ(norm(pulls[0].force), 0);
  EXPECT_EQ(norm(pulls[0].torque), 0);
}

}  // namespace
}  // namespace eerie::flight
