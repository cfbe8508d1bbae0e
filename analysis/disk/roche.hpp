#pragma once

namespace eerie::disk {

/// The factor A_1 of the gravity pi G rho A_1 a at the tip of a homogeneous prolate spheroid, whose
/// whole length is a (Chandrasekhar 1969, Ellipsoidal Figures of Equilibrium, table in section 17;
/// Sugiura et al. 2019, Eq. 13). It is 2/3 for a sphere. `b_over_a` lies in (0, 1].
double self_gravity_coefficient(double b_over_a);

/// The distance from a central body of the same density within which its tide, G M_c a / d^3,
/// disrupts a prolate body that points at it. It is (4 / (3 A_1))^(1/3) radii of the central body,
/// Eq. (14) of Sugiura et al. (2019), without rotation and without strength. `b_over_a` lies in (0,
/// 1].
double roche_distance(double b_over_a);

}  // namespace eerie::disk
