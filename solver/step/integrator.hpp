#pragma once

#include <variant>

#include "solver/base/token.hpp"

namespace eerie {

// An integrator is a list of moves of a system:
//   kick_and_drift(a, b)  everything but positions goes on for a seconds with the rates at hand,
//                         then positions for b seconds;
//   evaluate(c)           rates anew, everything but positions predicted c seconds ahead with the
//                         rates at hand;
//   kick(d)               everything but positions goes on for d seconds.
// The rates that a step ends with are what the next one begins with. A new integrator is one
// struct and one entry of the list; its order is measured by tests/step/integrator_contract.cpp.

/// Kick-drift-kick with predicted rates at the end of the step: second order, one evaluation.
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

/// The same, with rates predicted, evaluated, corrected and evaluated again: twice the price for
/// rates that fit the state they act on. It damps where the leapfrog slowly amplifies.
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

using Integrator = std::variant<Leapfrog, LeapfrogPece>;

}  // namespace eerie
