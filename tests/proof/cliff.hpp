#pragma once

#include <vector>

namespace eerie::proof {

/// A pile of grains that falls over in plane strain: a rectangle H0 high and L0 = 1 m wide on a
/// rough floor, against a slip wall at x = 0, released at rest under its own weight.
struct Pile {
  double aspect;           ///< H0/L0
  double phi_d_deg;        ///< friction angle of Drucker and Prager's law
  int across;              ///< particles over L0
  double sound = 10;       ///< sound speed over sqrt(2 g H0), the speed of free fall
  double viscosity = 0.2;  ///< alpha; beta is twice as much
};

/// Free surface of the largest connected piece, lengths in L0.
struct Surface {
  double time;  ///< in sqrt(H0/g)
  std::vector<double> x, y;
  double front, top;      ///< furthest point, highest point
  double kinetic_energy;  ///< over M g H0
};

/// The surface at the given times (in sqrt(H0/g), rising).
std::vector<Surface> collapse(const Pile& pile, const std::vector<double>& times);

/// Height of the surface at x, between its points; 0 beyond the front.
double height_at(const Surface& surface, double x);

/// Surfaces of the collapse of H0/L0 = 3.2, mu_d = tan 20.9 deg, read from fig. 1 of Jutzi (2015):
/// SPH with the same law of friction.
Surface published_start();  ///< one time unit after the release
Surface published_end();

/// Mean distance in height between a surface and the points of a published one, in L0.
double mean_difference(const Surface& surface, const Surface& published);
/// The outermost x at which the surface is `height` high: a front that single grains do not make.
double reach_at_height(const Surface& surface, double height);

}  // namespace eerie::proof
