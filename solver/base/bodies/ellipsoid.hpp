#pragma once

#include "solver/base/vec3.hpp"

namespace eerie {

/// The coefficients A of the attraction inside a homogeneous ellipsoid with `semi_axes` (of any
/// unit) along x, y and z. The field is -2 pi G rho (A_x x, A_y y, A_z z); their sum is 2
/// (Chandrasekhar 1969).
Vec3 attraction_coefficients(const Vec3& semi_axes);

/// The friction coefficient sqrt(J2)/p that a homogeneous ellipsoid of rubble needs to keep its
/// shape while it turns about z at omega (rad/s). rho in kg/m^3. J2 and p are those of the stress
/// averaged over the volume, sigma_xx = (rho a_x^2/5) (omega^2 - 2 pi G rho A_x) and so on, the
/// z-axis without omega (Holsapple 2001). Infinite where matter has no weight at the ends of an
/// axis.
double needed_friction(const Vec3& semi_axes, double rho, double omega);

}  // namespace eerie
