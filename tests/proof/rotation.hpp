#pragma once

#include <string>
#include <vector>

namespace eerie::proof {

/// An elastic sphere on a cubic lattice of 0.2 R that turns freely, without gravity, at
/// omega = (2 pi/100) c/R with rho = 1000 kg/m^3, R = 1 m, c = 1 m/s, G = rho c^2 (the test of
/// Sugiura's thesis, scaled in density).
struct Rotated {
  std::vector<double> turns, spin, angular_momentum, radius;  ///< the last three over their start
};

/// `gradient`: as in numerics.gradient. Throws NumericalError where the run breaks.
Rotated rotated_sphere(const std::string& gradient, double turns, double cfl = 0.5);

}  // namespace eerie::proof
