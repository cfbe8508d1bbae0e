#pragma once

#include <vector>

namespace eerie::proof {

/// Gas at one place: kg/m^3, m/s, Pa.
struct Gas {
  double rho, v, p;
};

/// Exact solution of Riemann's problem for an ideal gas (Toro 2009, ch. 4): two gases, separate
/// until t = 0 at x = 0, along x/t = `speed`.
Gas riemann(const Gas& left, const Gas& right, double gamma, double speed);

/// Sod's (1978) shock tube in SI: density 8:1, pressure 10:1, gamma 1.4. Equal masses, so the
/// dense half is a cubic lattice of half the spacing. `half`: particles along the dense half.
struct Sod {
  static constexpr Gas left{1000, 0, 1e5}, right{125, 0, 1e4};
  static constexpr double gamma = 1.4, length = 1, time = 0.02;
  std::vector<double> x, rho, v, p;    ///< of all particles, sorted by x
  double error_rho, error_v, error_p;  ///< mean over the volume, over the largest value
  double energy_drift;                 ///< of the total, relative
};
Sod sod_tube(int half, double h_over_spacing);

/// A standing elastic wave between slip walls, half a wave over a side, and its speed over that of
/// theory, sqrt((K + 4G/3)/rho) or sqrt(G/rho), from the time between two zero crossings.
/// Longitudinal: v_x ~ sin(k x). Shear: Lame's mode v ~ (sin(k x) cos(k y), -cos(k x) sin(k y)) of
/// a square, which slip walls leave free and which has the wave number sqrt(2) k.
enum class Wave { longitudinal, shear };
double wave_speed_ratio(Wave wave, int across);
/// What smoothing on a lattice makes of that ratio. The gradients of density and pressure are not
/// corrected and come out too small by the lattice sum C (0.982 at h = 1.2 spacings); and a kernel
/// of variance 0.3 h^2 lowers each gradient of a wave by 0.15 (k h)^2.
double expected_speed_ratio(Wave wave, int across);

}  // namespace eerie::proof
