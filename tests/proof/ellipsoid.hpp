#pragma once

#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::proof {

/// Largest W = omega^2/(2 pi G rho) at which a cohesionless ellipsoid of semi-axes a >= b >= c
/// that spins about c can stand with friction coefficient mu_d (sqrt(J2) <= mu_d p), and whether
/// it can at all. From the averages over the volume of x_i d(sigma_ij)/dx_j = rho x_i (a_i - g_i):
///   sigma_xx = rho a^2/5 (omega^2 - 2 pi G rho A_x),   sigma_zz = -rho c^2/5 2 pi G rho A_z,
/// with Chandrasekhar's (1969) coefficients A_i of the attraction inside a uniform ellipsoid.
struct StabilityLimit {
  bool stands = false;  ///< for some spin
  double slowest = 0;   ///< smallest W at which it stands; above 0 where gravity alone breaks it
  double fastest = 0;   ///< largest W
};
StabilityLimit stability_limit(double a, double b, double c, double mu_d);

/// The smallest b/a = c/a, to 0.001, at which such an ellipsoid stands without spin.
double lowest_standing(double mu_d);

/// Ratio of the axes of a body's equal-inertia ellipsoid, and the spin W about its shortest axis.
struct Figure3 {
  double b_over_a, c_over_a, a, W;
};
Figure3 figure_of(const Scene& scene, const particles::State& state);

/// A body of `scene` pressed into the axes ratios b/a = c/a = `ratio`, of unchanged volume,
/// spinning at W; brought to rest in its own frame with more friction than it will have.
particles::State resting_ellipsoid(const Scene& scene, double ratio, double W);

/// Follows it at `scene`'s friction for `seconds` while W^(1/2) rises evenly to that of W_end.
/// Returns the W at which a has grown by `failure` of itself, or -1 where it never has.
struct SpinUp {
  double W_failed = -1;
  Figure3 last;
};
SpinUp spun_up(const Scene& scene, particles::State state, double W_begin, double W_end,
               double seconds, double failure);

}  // namespace eerie::proof
