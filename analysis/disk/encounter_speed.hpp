#pragma once

#include "analysis/disk/drag.hpp"

namespace eerie::disk {

/// Between these speeds (m/s) impacts can leave extremely elongated remnants; Sugiura et al.
/// (2019), section 4.
inline constexpr double slow = 0.15, fast = 0.40;

/// Relative speed of two equal bodies in turbulence of strength alpha (Shakura & Sunyaev), m/s:
/// c sqrt(3 alpha / (Omega t_s)), Sugiura et al. (2019), Eq. (7); holds for Omega t_s >> 1.
double turbulent_speed(const Nebula& nebula, const Drag& drag, double alpha);

/// The alpha at which they meet with `speed` (m/s): the inverse of turbulent_speed.
double alpha_at_speed(const Nebula& nebula, const Drag& drag, double speed);

/// Large planetesimals among the small ones.
struct Stirrers {
  double solid_fraction = 0.01;  ///< of the surface density of all solids
  double density = 2700;         ///< kg/m^3
};

/// Relative speed (m/s) at which stirring by bodies of radius `radius` (m) and drag balance:
/// (t_s Omega Sigma / (rho_s R))^(1/4) v_esc, Sugiura et al. (2019), Eq. (10).
double stirred_speed(const Nebula& nebula, const Drag& drag, const Stirrers& stirrers,
                     double radius);

/// The radius (m) of stirrers at which the small ones meet with `speed` (m/s): the inverse of
/// stirred_speed.
double stirrer_radius_at_speed(const Nebula& nebula, const Drag& drag, const Stirrers& stirrers,
                               double speed);

}  // namespace eerie::disk
