#pragma once

#include "solver/base/vec3.hpp"
#include "solver/scene/tide.hpp"

namespace eerie::initial {

/// The relative position and velocity (impactor minus target) of two bodies, in SI.
struct RelativeOrbit {
  Vec3 position, velocity;
};

/// The state at contact: the centres are `contact` apart, the relative speed is v_imp, and the
/// velocity makes the angle theta_imp (0: head-on) with the line of centres. The velocity points
/// along -x, the orbit lies in the x-y plane, and its angular momentum points along +z.
RelativeOrbit orbit_at_contact(double contact, double v_imp, double theta_imp);

/// The state on the same Kepler orbit, with mu = G (M_t + M_i), at the earlier time when the
/// distance was `distance` and decreasing. Throws InputError where the bodies never were that far
/// apart (v_imp below the escape speed).
RelativeOrbit orbit_before_contact(const RelativeOrbit& at_contact, double mu, double distance);

/// The same with the tide of a primary, whose azimuth is that of the earlier time. `share` is the
/// impactor's part of the mass. It is integrated as if the centre of both stayed on its circle,
/// which the tide's unevenness forbids: at three contact distances and a tenth of the way to the
/// primary the contact is missed by 0.3 % of its distance.
RelativeOrbit orbit_before_contact(const RelativeOrbit& at_contact, double mu, double distance,
                                   const Tide& tide, double share);

}  // namespace eerie::initial
