#include "analysis/disk/roche.hpp"

#include <cmath>

namespace eerie::disk {

double self_gravity_coefficient(double b_over_a) {
  const double b2 = b_over_a * b_over_a, e2 = 1 - b2;
  // The closed form takes 1/e^2 from 1/e^2; below, its series 2 b^2 sum e^(2k) / (2k + 3).
  if (e2 < 0.05) {
    double sum = 0, power = 1;
    for (int k = 0; k < 14; ++k, power *= e2) sum += power / (2 * k + 3);
    return 2 * b2 * sum;
  }
  const double e = std::sqrt(e2);
  return 2 * b2 / e2 * (std::atanh(e) / e - 1);
}

double roche_distance(double b_over_a) {
  return std::cbrt(4 / (3 * self_gravity_coefficient(b_over_a)));
}

}  // namespace eerie::disk
