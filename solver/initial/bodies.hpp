#pragma once

#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::initial {

/// One body alone at the origin, at rest: packed with particles, given the hydrostatic density
/// profile of a self-gravitating sphere, then settled by damped steps of the solver itself until
/// its own forces balance. Ids are 0..n-1. Throws NumericalError if it does not come to rest.
particles::State make_body(const Scene& scene, particles::Body body);

/// Target and impactor on their orbit, `impact.separation` contact distances apart, in the
/// frame of their common centre of mass; time 0. Ids run through the target first.
particles::State make_impact(const Scene& scene);

/// The same with bodies that have not come to rest: made at once, for measuring speed.
particles::State make_unsettled_impact(const Scene& scene);

}  // namespace eerie::initial
