#pragma once

#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::proof {

/// A sphere of rubble whose spin rises evenly, as light and heat of the Sun raise it, until it has
/// flattened; then it is left alone.
struct SpinUpOfSphere {
  double W_greatest;      ///< omega^2/(2 pi G rho): what flattens turns more slowly
  double c_over_a;        ///< as the spin stops to rise
  double c_over_a_alone;  ///< after the time alone
  /// Displacement of what lay within 0.6 of the radius over that of what lay beyond 0.9 (medians),
  /// in units of that of an even strain: 1 where the whole body deforms, 0 where grains slide on
  /// its surface.
  double interior;
  double shed;  ///< part of the particles beyond twice the radius in the end
};

/// `scene`'s target; W^(1/2) rises by that of W = 1 in `rise_s`, from `W_begin` on, until c/a is
/// `flat`; then `alone_s` without torque.
SpinUpOfSphere spin_up_of_sphere(const Scene& scene, double W_begin, double rise_s, double flat,
                                 double alone_s);

}  // namespace eerie::proof
