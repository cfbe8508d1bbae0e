#pragma once

namespace eerie::proof {

/// Run-out of a plane column of grains, (x - L0)/L0.
struct RunOut {
  double aspect;          ///< H0/L0
  double front;           ///< where the surface is two particles high
  double tip;             ///< the furthest connected grain
  double kinetic_energy;  ///< left at the end, over M g H0
};

/// collapse() of cliff.hpp until 6 sqrt(H0/g), with phi_d = 27.2 deg. In plane strain the flow has
/// sqrt(J2) = (s1 - s3)/2 and p = (s1 + s3)/2, so that mu_d is the sine of the angle of Mohr and
/// Coulomb: 31 deg, that of the sand of Lube et al. (2005). `across`: particles over L0.
RunOut run_out(double aspect, int across);

/// The laws of experiments, each branch up to where it meets the other.
double lube(double aspect);        ///< 1.2 a, 1.9 a^(2/3): Lube et al. (2005)
double lajeunesse(double aspect);  ///< 1.8 a, 2.3 a^(2/3): Lajeunesse, Monnier & Homsy (2005)

}  // namespace eerie::proof
