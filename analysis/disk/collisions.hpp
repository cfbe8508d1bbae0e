#pragma once

namespace eerie::disk {

/// The impact speeds of collisions in a swarm whose relative velocities far away are Maxwellian.
/// Gravity focuses: the cross-section of a pair is pi (R_t + R_i)^2 (1 + v_esc^2 / v_inf^2), so
/// that collisions have v_inf with density (v_inf^3 + v_esc^2 v_inf) exp(-v_inf^2 / 2 s^2), and
/// v_imp^2 = v_inf^2 + v_esc^2 (Safronov 1969; Greenzweig & Lissauer 1992). All speeds have one
/// unit, whichever it is.
struct CollisionSpeeds {
  double dispersion = 0;  ///< s, of one component of the relative velocity
  double v_esc = 0;       ///< mutual escape speed at contact

  /// The fraction of collisions with an impact speed below `v_imp`.
  double share_below(double v_imp) const;
  /// The impact speed below which half of the collisions are.
  double median() const;
};

/// The fraction of collisions with an impact angle below `theta` (rad, 0 is head-on) where
/// directions are isotropic: sin^2 theta (Shoemaker 1962).
double share_below_angle(double theta);

}  // namespace eerie::disk
