#pragma once

namespace eerie::proof {

// Two layers of one particle mass, whose spacings are as 3 to 2 and densities as 8 to 27, the most
// that scenes may have.

inline constexpr double light_density = 800, dense_density = 2700;  // kg/m^3

/// The lowest standing longitudinal wave of an elastic bar between slip walls, half of it light and
/// half dense, and its frequency over that of theory: with k = omega/c_l in each half of length L,
///   Z_1 cot(k_1 L) + Z_2 cot(k_2 L) = 0,   Z = rho c_l.
/// `across`: particles of the dense half along its length, a multiple of 3.
double layered_wave_ratio(int across);

/// A light liquid on a dense one, at rest in a box under gravity.
struct LayeredLiquid {
  /// Pressure of each layer over that of its depth, mean over its particles that are at least two
  /// spacings below the surface.
  double light, dense;
  double voids;  ///< part of all particles that press nothing
  double speed;  ///< root mean square in the end, over sqrt(g H)
};
LayeredLiquid layered_liquid(int across);

}  // namespace eerie::proof
