#pragma once

#include <functional>

#include "analysis/flight/rigid_body.hpp"

namespace eerie::flight {

/// The settings of a flight of rigid clumps, and what ends it.
struct FlightPlan {
  double until_s = 0;           ///< latest simulated time at which it ends
  double spacing = 0;           ///< (m/rho0)^(1/3), m
  double opening_angle = 0.35;  ///< opening angle of gravity (tree/gravity.hpp)
  double heavy = 0;             ///< kg; the flight ends before two bodies of this mass touch
  double most_landed = 0;       ///< kg; the flight ends once so much has landed
  std::function<bool(const particles::State&)>
      waits;                   ///< called now and then; where it is false the flight ends
  std::function<bool()> stop;  ///< called after every step; where it is true the flight ends
};

enum class FlightEnd { time, encounter, landed, nothing_left, stopped };

struct Flight {
  particles::State state;  ///< the state at the end; particles keep their order
  FlightEnd end = FlightEnd::time;
  double landed = 0;  ///< mass that has stuck to another body, kg
  long steps = 0;
};

/// Moves clumps (clumps.hpp) as rigid bodies through the gravity of all particles; the solver need
/// not compute matter that does not change. Kick-drift-kick advances centres of mass and rotations,
/// in steps of a small part of the orbital time of the closest pair. A body that comes within 1.2
/// spacings of another sticks to it and keeps momentum and angular momentum. Where both are heavy
/// the flight ends shortly before. The result has the same bits for any number of threads.
Flight fly(particles::State state, const FlightPlan& plan);

}  // namespace eerie::flight
