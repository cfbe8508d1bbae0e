#pragma once

#include <functional>

#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"
#include "solver/step/solver.hpp"

namespace eerie::initial {

/// A body on its way to rest: packed with particles, given the hydrostatic density profile of a
/// self-gravitating sphere, then settled by damped steps of the solver itself until its own forces
/// balance. Between two cycles it may be put away and gone on with: the same bits come out.
class Settling {
 public:
  /// Throws PackingStopped where `stop` says so while particles are packed.
  Settling(const Scene& scene, particles::Body body, const std::function<bool()>& stop = {});
  /// Goes on with what solver() was.
  Settling(const Scene& scene, particles::Body body, step::Solver begun);

  bool is_at_rest() const;
  /// A few damped steps. Throws NumericalError where it does not come to rest.
  void cycle();
  const step::Solver& solver() const { return solver_; }
  /// At the origin, without speed and heat, at time 0; ids are 0..n-1.
  particles::State body() const;

 private:
  Scene scene_;
  particles::Body body_;
  double radius_;    ///< m
  double crossing_;  ///< of sound, s
  step::Solver solver_;
};

/// One body alone at the origin, at rest: Settling to its end. Throws NumericalError if it does not
/// come to rest.
particles::State make_body(const Scene& scene, particles::Body body);

/// Target and impactor on their orbit, `impact.separation` contact distances apart, in the
/// frame of their common centre of mass; time 0. Ids run through the target first.
particles::State make_impact(const Scene& scene);

/// Two bodies, as Settling leaves them, on their orbit.
particles::State on_their_orbit(const Scene& scene, const particles::State& target,
                                const particles::State& impactor);

/// Throws InputError where there is no orbit that brings the bodies together as the scene says:
/// known before they are made.
void require_orbit(const Scene& scene);

/// make_impact with bodies that have not come to rest: made at once, for measuring speed.
particles::State make_unsettled_impact(const Scene& scene);

}  // namespace eerie::initial
