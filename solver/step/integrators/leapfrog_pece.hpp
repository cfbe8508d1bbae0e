#pragma once

namespace eerie::step {

/// The leapfrog with a second evaluation: it predicts, evaluates, corrects and evaluates again
/// (PECE). A step costs twice as much, and its rates belong to the corrected state. It damps waves
/// that the leapfrog slowly amplifies.
struct LeapfrogPece {
  static constexpr const char* token = "leapfrog-pece";
  static constexpr int order = 2, evaluations = 2;
  template <class System>
  static void step(System& system, double dt) {
    system.kick_and_drift(dt / 2, dt);
    system.evaluate(dt / 2);
    system.evaluate(dt / 2);
    system.kick(dt / 2);
  }
};

}  // namespace eerie::step
