#pragma once

#include <variant>

#include "solver/base/token.hpp"
#include "solver/step/integrators/leapfrog.hpp"
#include "solver/step/integrators/leapfrog_pece.hpp"

namespace eerie::step {

// An integrator is a list of moves of a system:
//   kick_and_drift(a, b)  everything but positions goes on for a seconds with the rates at hand,
//                         then positions for b seconds;
//   evaluate(c)           rates anew, everything but positions predicted c seconds ahead with the
//                         rates at hand;
//   kick(d)               everything but positions goes on for d seconds.
// The rates that a step ends with are what the next one begins with. A new integrator is one
// file in integrators/ and one entry of the list; its order is measured by
// tests/step/integrator_contract.cpp.

/// Every integrator.
using Integrator = std::variant<Leapfrog, LeapfrogPece>;

}  // namespace eerie::step
