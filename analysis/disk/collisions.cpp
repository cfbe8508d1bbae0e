#include "analysis/disk/collisions.hpp"

#include <cmath>

namespace eerie::disk {

double CollisionSpeeds::share_below(double v_imp) const {
  const double v2 = v_imp * v_imp - v_esc * v_esc, s2 = dispersion * dispersion;
  if (v2 <= 0) return 0;
  const double x = v2 / (2 * s2), focus = v_esc * v_esc / s2;
  return 1 - (2 * (x + 1) + focus) / (2 + focus) * std::exp(-x);
}

double CollisionSpeeds::median() const {
  double low = v_esc, high = v_esc + 10 * dispersion;
  for (int n = 0; n < 60; ++n) {
    const double middle = (low + high) / 2;
    (share_below(middle) < 0.5 ? low : high) = middle;
  }
  return low;
}

double share_below_angle(double theta) {
  const double sine = std::sin(theta);
  return sine * sine;
}

}  // namespace eerie::disk
