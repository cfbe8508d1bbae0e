#pragma once

#include <functional>

#include "analysis/flight/rigid_body.hpp"

namespace eerie::flight {

/// How clumps fly, and what ends a flight.
struct FlightPlan {
  double until_s = 0;           ///< simulated time at which it ends at the latest
  double spacing = 0;           ///< (m/rho0)^(1/3), m
  double opening_angle = 0.35;  ///< of gravity (tree/gravity.hpp)
  double heavy = 0;             ///< kg; a flight ends before two so heavy bodies touch
  double most_landed = 0;       ///< kg; and once so much has landed
  std::function<bool(const particles::State&)>
      waits;                   ///< asked now and then; false: nothing is left to wait for
  std::function<bool()> stop;  ///< asked after every step
};

enum class FlightEnd { time, encounter, landed, nothing_left, stopped };

struct Flight {
  particles::State state;  ///< as it is at the end, in the order that it had
  FlightEnd end = FlightEnd::time;
  double landed = 0;  ///< kg that stuck to something
  long steps = 0;
};

/// Clumps (clumps.hpp) fly as rigid bodies through the gravity of all particles, instead of being
/// computed as matter that does not change: centre of mass and rotation by kick-drift-kick, steps a
/// small part of the orbital time of the closest pair. Whatever comes within 1.2 spacings of
/// another body sticks to it, momentum and angular momentum kept; that ends the flight, shortly
/// before, where both are heavy. Same bits for any number of threads.
Flight fly(particles::State state, const FlightPlan& plan);

}  // namespace eerie::flight
