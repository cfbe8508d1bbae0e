#include "analysis/disk/encounter_speed.hpp"

#include <cmath>

#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"

namespace eerie::disk {

double turbulent_speed(const Nebula& n, const Drag& drag, double alpha) {
  return n.sound_speed * std::sqrt(3 * alpha / (n.omega_k * drag.stopping_time));
}

double alpha_at_speed(const Nebula& n, const Drag& drag, double speed) {
  const double mach = speed / n.sound_speed;
  return mach * mach * n.omega_k * drag.stopping_time / 3;
}

double stirred_speed(const Nebula& n, const Drag& drag, const Stirrers& s, double radius) {
  const double sigma = s.solid_fraction * n.solid_surface_density;
  return std::pow(drag.stopping_time * n.omega_k * sigma / (s.density * radius), 0.25) *
         escape_speed({radius, s.density});
}

double stirrer_radius_at_speed(const Nebula& n, const Drag& drag, const Stirrers& s, double speed) {
  // The speed goes as R^(3/4).
  return std::pow(speed / stirred_speed(n, drag, s, 1), 4.0 / 3);
}

}  // namespace eerie::disk
