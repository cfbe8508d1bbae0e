#pragma once

namespace eerie::step {

/// Velocity Verlet with the stress staggered against the velocity: what strains is the velocity in
/// the middle of a step, what pushes is the stress at its end. Gradient and force are visits of
/// their own, each with the sums that it needs, so a step costs little more than one visit for all;
/// the correction matrix of the force is of the same step, and the shortest waves do not grow.
struct Staggered {
  static constexpr const char* token = "staggered";
  static constexpr int order = 2, evaluations = 1;
  template <class System>
  static void step(System& system, double dt) {
    system.push_and_drift(dt / 2, dt);
    system.deform(dt);
    system.exert(dt / 2);
    system.push(dt / 2);
  }
};

}  // namespace eerie::step
