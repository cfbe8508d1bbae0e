#pragma once

#include "solver/base/vec3.hpp"

namespace eerie::initial {

/// Relative position and velocity (impactor minus target) of two bodies, SI.
struct RelativeOrbit {
  Vec3 position, velocity;
};

/// Contact at distance `contact` with speed v_imp, the velocity at angle theta_imp to the line of
/// centres (0: head-on). The velocity at contact points along -x, the orbit lies in the x-y
/// plane, its angular momentum along +z.
RelativeOrbit orbit_at_contact(double contact, double v_imp, double theta_imp);

/// The same two-body orbit (Kepler, gravitational parameter mu = G (M_t + M_i)) at the earlier
/// time when the distance was `distance` and shrinking. Throws InputError when the orbit never
/// was that far apart (v_imp below the escape speed).
RelativeOrbit orbit_before_contact(const RelativeOrbit& at_contact, double mu, double distance);

}  // namespace eerie::initial
