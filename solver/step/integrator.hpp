#pragma once

#include <variant>

#include "solver/base/token.hpp"
#include "solver/step/integrators/leapfrog.hpp"
#include "solver/step/integrators/leapfrog_pece.hpp"
#include "solver/step/integrators/staggered.hpp"

namespace eerie::step {

// An integrator is a list of moves of a system.
//
// These are the moves where all rates belong to one time:
//   kick_and_drift(a, b): everything but positions advances by a seconds with the present rates,
//     then positions advance by b seconds.
//   evaluate(c): computes new rates; everything but positions is predicted c seconds ahead with
//     the present rates.
//   kick(d): everything but positions advances by d seconds.
//
// These are the moves where stress is staggered against velocity:
//   push_and_drift(a, b): velocities advance by a seconds with the present forces, then positions
//     advance by b seconds.
//   deform(d): everything else advances by the d seconds of that drift, by the velocity gradient
//     in the middle of it.
//   exert(c): computes new forces; velocities are predicted c seconds ahead with the present
//     forces.
//   push(d): velocities advance by d seconds.
//
// A step begins with the rates with which the last one ended. A new integrator is one file in
// integrators/ and one entry of the list below; tests/step/integrator_contract.cpp measures its
// order.

/// The list of all integrators.
using Integrator = std::variant<Leapfrog, LeapfrogPece, Staggered>;

}  // namespace eerie::step
