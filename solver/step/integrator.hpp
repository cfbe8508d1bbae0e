#pragma once

#include <variant>

#include "solver/base/token.hpp"
#include "solver/step/integrators/leapfrog.hpp"
#include "solver/step/integrators/leapfrog_pece.hpp"
#include "solver/step/integrators/staggered.hpp"

namespace eerie::step {

// An integrator is a list of moves of a system:
//   kick_and_drift(a, b)  everything but positions goes on for a seconds with the rates at hand,
//                         then positions for b seconds;
//   evaluate(c)           rates anew, everything but positions predicted c seconds ahead with the
//                         rates at hand;
//   kick(d)               everything but positions goes on for d seconds.
// or, where stress is staggered against velocity,
//   push_and_drift(a, b)  velocities go on for a seconds with the forces at hand, then positions
//   for b; deform(d)             everything else goes on for the d seconds of that drift, by the
//   velocity
//                         gradient in the middle of it;
//   exert(c)              forces anew, velocities predicted c seconds ahead with the forces at
//   hand; push(d)               velocities go on for d seconds.
// The rates that a step ends with are what the next one begins with. A new integrator is one
// file in integrators/ and one entry of the list; its order is measured by
// tests/step/integrator_contract.cpp.

/// Every integrator.
using Integrator = std::variant<Leapfrog, LeapfrogPece, Staggered>;

}  // namespace eerie::step
