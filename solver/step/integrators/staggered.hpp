#pragma once

namespace eerie::step {

/// Velocity Verlet with stress staggered against velocity: the velocity in the middle of a step
/// strains, and the stress at its end pushes. Gradient and force take separate visits of the
/// neighbours, each with its own sums, so a step costs little more than one joint visit. The force
/// has the correction matrix of the same step, and the shortest waves do not grow.
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
