#pragma once

namespace eerie::disk {

/// Gravity at the tip of a homogeneous prolate spheroid is pi G rho A_1 a, a its whole length
/// (twice the semi-axis); Chandrasekhar (1969), Ellipsoidal Figures of Equilibrium, table in
/// section 17; Sugiura et al. (2019), Eq. (13). 2/3 for a sphere. `b_over_a` in (0, 1].
double self_gravity_coefficient(double b_over_a);

/// Distance from a body of the same density within which its tide, G M_c a / d^3, takes a prolate
/// body apart that points at it, in radii of that body: (4 / (3 A_1))^(1/3), Sugiura et al. (2019),
/// Eq. (14). Without rotation and without strength. `b_over_a` in (0, 1].
double roche_distance(double b_over_a);

}  // namespace eerie::disk
