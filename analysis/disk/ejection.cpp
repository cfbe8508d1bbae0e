#include "analysis/disk/ejection.hpp"

#include <cmath>

namespace eerie::disk {

double hill_radius(double distance, double mass_ratio) {
  return distance * std::cbrt(mass_ratio / 3);
}

double circumbinary_limit(double mass_fraction, double eccentricity) {
  const double m = mass_fraction, e = eccentricity;
  return 1.60 + 5.10 * e - 2.22 * e * e + 4.12 * m - 4.27 * e * m - 5.09 * m * m +
         4.61 * e * e * m * m;
}

}  // namespace eerie::disk
