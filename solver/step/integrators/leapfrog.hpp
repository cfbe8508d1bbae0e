#pragma once

namespace eerie::step {

/// The kick-drift-kick leapfrog, with predicted rates at the end of the step. It is of second order
/// and needs one evaluation per step.
struct Leapfrog {
  static constexpr const char* token = "leapfrog";
  static constexpr int order = 2, evaluations = 1;
  template <class System>
  static void step(System& system, double dt) {
    system.kick_and_drift(dt / 2, dt);
    system.evaluate(dt / 2);
    system.kick(dt / 2);
  }
};

}  // namespace eerie::step
