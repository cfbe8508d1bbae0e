#pragma once

#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"

namespace eerie {

/// One body alone at the origin, at rest: packed with particles, given the hydrostatic density
/// profile of a self-gravitating sphere, then settled by damped steps of the solver itself until
/// its own forces balance. Ids are 0..n-1. Throws NumericalError if it does not come to rest.
State make_body(const Scene& scene, Body body);

/// Central pressure of a homogeneous sphere, (2/3) pi G rho0^2 R^2, Pa.
double central_pressure(double rho0, double radius);

/// Escape speed from the surface of a homogeneous sphere, R sqrt((8/3) pi G rho0), m/s.
double escape_speed(double rho0, double radius);

/// Target and impactor on their orbit, `impact.separation` contact distances apart, in the
/// frame of their common centre of mass; time 0. Ids run through the target first.
State make_impact(const Scene& scene);

/// The same with bodies that have not come to rest: made at once, for measuring speed.
State make_unsettled_impact(const Scene& scene);

}  // namespace eerie
