#pragma once

#include <functional>
#include <string>

#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"
#include "solver/step/solver.hpp"

namespace eerie::initial {

/// A body on its way to rest. It is packed with particles and gets the hydrostatic density profile
/// of a self-gravitating sphere. Damped steps of the solver then settle it until its forces
/// balance, about its rotation where it spins. A run may be interrupted between two cycles and
/// continues with the same bits.
class Settling {
 public:
  /// Throws PackingStopped where `stop` returns true while particles are packed.
  Settling(const Scene& scene, particles::Body body, const std::function<bool()>& stop = {});
  /// Continues from the solver of an interrupted settling.
  Settling(const Scene& scene, particles::Body body, step::Solver begun);

  bool is_at_rest() const;
  /// Makes a few damped steps. Throws NumericalError where the body does not come to rest.
  void cycle();
  const step::Solver& solver() const { return solver_; }
  /// The body at the origin at time 0, with the velocities of its rotation and without heat. Its
  /// ids are 0 to n-1. Throws NumericalError where an ellipsoid has flowed.
  particles::State body() const;

 private:
  Scene scene_;
  particles::Body body_;
  double radius_;    ///< m
  double crossing_;  ///< time that sound needs to cross the body, s
  Vec3 omega_;       ///< angular velocity, rad/s
  step::Solver solver_;
};

/// "target" or "impactor".
const char* name_of(particles::Body body);

/// The SHA-256 (hexadecimal) of all that decides the bits of a body at rest. Scenes that differ in
/// what happens to it later, or in the other body, have it in common.
std::string body_hash(const Scene& scene, particles::Body body);

/// Makes one body alone, at rest at the origin, by Settling to its end. Throws NumericalError where
/// it does not come to rest.
particles::State make_body(const Scene& scene, particles::Body body);

/// Makes target and impactor on their orbit at time 0, `impact.separation` contact distances apart,
/// in the frame of their common centre of mass. The particles of the target have the first ids.
particles::State make_impact(const Scene& scene);

/// Puts two bodies, as Settling leaves them, on their orbit.
particles::State on_their_orbit(const Scene& scene, const particles::State& target,
                                const particles::State& impactor);

/// Throws InputError where no orbit brings the bodies together as the scene says. It needs no
/// bodies, so mistakes show at once.
void require_orbit(const Scene& scene);

/// make_impact() with bodies that have not come to rest. It is quick and serves measurements of
/// speed.
particles::State make_unsettled_impact(const Scene& scene);

}  // namespace eerie::initial
