#include "analysis/flight/flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/flight/mutual_gravity.hpp"
#include "analysis/flight/spheres.hpp"
#include "solver/base/constants.hpp"

namespace eerie::flight {

namespace {

/// Step over sqrt(d^3/(G (m1 + m2))) of any pair with a heavy body, and over the time in which one
/// turns by a radian.
constexpr double step_over_orbit = 0.03, step_over_turn = 0.05;
constexpr double longest_step = 300;  // s
/// The caller is asked what is waited for every so many steps.
constexpr long steps_unasked = 50;
constexpr double contact_in_spacings = 1.2, room_in_h = 3;
/// Parts of a step in which a contact is looked for.
constexpr int parts = 16;

class Flying {
 public:
  Flying(particles::State&& state, const FlightPlan& plan)
      : plan_(plan),
        state_(std::move(state)),
        contact_(std::min(contact_in_spacings * plan.spacing,
                          remnants::linking_length_over_h * state_.h)),
        gravity_({state_.mass, state_.h, plan.opening_angle}, plan.heavy) {
    for (remnants::Clump& clump : remnants::friends_of_friends(
             state_.x, state_.id, remnants::linking_length_over_h * state_.h))
      bodies_.push_back(rigid_body(state_, std::move(clump)));
    gravity_.take(bodies_, state_.id);
    pulls_ = gravity_.pulls(bodies_);
  }

  Flight go() {
    FlightEnd end = FlightEnd::time;
    long steps = 0;
    for (; state_.time < plan_.until_s; ++steps) {
      if (plan_.stop && plan_.stop()) {
        end = FlightEnd::stopped;
        break;
      }
      if (heavy_ones_meet()) {
        end = FlightEnd::encounter;
        break;
      }
      if (landed_ > 0 && landed_ >= plan_.most_landed) {
        end = FlightEnd::landed;
        break;
      }
      if (steps % steps_unasked == 0 && plan_.waits && !plan_.waits(as_particles())) {
        end = FlightEnd::nothing_left;
        break;
      }
      step();
    }
    return {as_particles(), end, landed_, steps};
  }

 private:
  void step() {
    const double dt = std::min(time_step(), plan_.until_s - state_.time);
    kick(dt / 2);
    for (RigidBody& body : bodies_) body.drift(dt);
    state_.time += dt;
    land(dt);
    pulls_ = gravity_.pulls(bodies_);
    kick(dt / 2);
  }

  void kick(double duration) {
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      bodies_[b].kick(pulls_[b].force, pulls_[b].torque, duration);
  }

  bool is_heavy(const RigidBody& body) const { return body.mass >= plan_.heavy; }

  double time_step() const {
    double dt = longest_step;
    for (std::size_t a = 0; a < bodies_.size(); ++a) {
      if (!is_heavy(bodies_[a])) continue;
      const double turning = norm(bodies_[a].angular_velocity());
      if (turning > 0) dt = std::min(dt, step_over_turn / turning);
      for (std::size_t b = 0; b < bodies_.size(); ++b) {
        if (b == a) continue;
        const double d = norm(bodies_[a].x - bodies_[b].x);
        const double mu = newton_G * (bodies_[a].mass + bodies_[b].mass);
        dt = std::min(dt, step_over_orbit * std::sqrt(d * d * d / mu));
      }
    }
    return dt;
  }

  bool heavy_ones_meet() const {
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      for (std::size_t b = a + 1; b < bodies_.size() && is_heavy(bodies_[a]); ++b)
        if (is_heavy(bodies_[b]) && norm(bodies_[a].x - bodies_[b].x) < bodies_[a].radius +
                                                                            bodies_[b].radius +
                                                                            room_in_h * state_.h)
          return true;
    return false;
  }

  /// Sticks together what has come into contact within the last `dt`, at the place where it did.
  void land(double dt) {
    spheres_.take(bodies_);
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      for (std::size_t b = a; (b = spheres_.next_within(contact_, a, b)) < bodies_.size();) {
        if (!touch(bodies_[a], bodies_[b], contact_)) continue;
        landed_ += std::min(bodies_[a].mass, bodies_[b].mass);
        stick(a, b, dt);
        b = a;  // what is larger now may touch more
      }
    if (std::exchange(has_landed_, false)) gravity_.take(bodies_, state_.id);
  }

  /// They stick where they first touched, and go on from there as one.
  void stick(std::size_t a, std::size_t b, double dt) {
    RigidBody &one = bodies_[a], &other = bodies_[b];
    const double part = dt / parts;
    int back = 0;
    for (; back < parts; ++back) {
      const RigidBody::Place here = one.place(), there = other.place();
      one.drift(-part), other.drift(-part);
      if (!touch(one, other, contact_)) {
        one.move_to(here), other.move_to(there);
        break;
      }
    }
    one = stuck_together(std::move(one), std::move(other), state_);
    one.drift(back * part);
    spheres_.set(a, one);
    spheres_.erase(b);
    bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(b));
    has_landed_ = true;
  }

  particles::State as_particles() const {
    particles::State state = state_;
    for (const RigidBody& body : bodies_) put_back(body, state);
    return state;
  }

  const FlightPlan& plan_;
  particles::State state_;
  double contact_;  ///< m
  std::vector<RigidBody> bodies_;
  Spheres spheres_;  ///< of the bodies
  std::vector<Pull> pulls_;
  MutualGravity gravity_;
  double landed_ = 0;
  bool has_landed_ = false;
};

}  // namespace

Flight fly(particles::State state, const FlightPlan& plan) {
  return Flying(std::move(state), plan).go();
}

}  // namespace eerie::flight
