#pragma once

#include "analysis/disk/drag.hpp"

namespace eerie::disk {

/// Impacts between these speeds (m/s) can leave extremely elongated remnants (Sugiura et al. 2019,
/// section 4).
inline constexpr double slow = 0.15, fast = 0.40;

/// The relative speed of two equal bodies in turbulence of strength alpha (Shakura & Sunyaev), m/s:
/// c sqrt(3 alpha / (Omega t_s)), Eq. (7) of Sugiura et al. (2019). It holds for Omega t_s >> 1.
double turbulent_speed(const Nebula& nebula, const Drag& drag, double alpha);

/// The alpha at which they meet with `speed` (m/s), the inverse of turbulent_speed().
double alpha_at_speed(const Nebula& nebula, const Drag& drag, double speed);

/// The large planetesimals that stir the small ones.
struct Stirrers {
  double solid_fraction = 0.01;  ///< in units of the surface density of all solids
  double density = 2700;         ///< kg/m^3
};

/// The relative speed (m/s) at which drag balances the stirring by bodies of radius `radius` (m):
/// (t_s Omega Sigma / (rho_s R))^(1/4) v_esc, Eq. (10) of Sugiura et al. (2019).
double stirred_speed(const Nebula& nebula, const Drag& drag, const Stirrers& stirrers,
                     double radius);

/// The radius (m) of stirrers at which the small bodies meet with `speed` (m/s), the inverse of
/// stirred_speed().
double stirrer_radius_at_speed(const Nebula& nebula, const Drag& drag, const Stirrers& stirrers,
                               double speed);

}  // namespace eerie::disk
