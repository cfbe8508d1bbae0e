#include "analysis/statistics/student.hpp"

#include <cmath>

#include "solver/base/constants.hpp"

namespace eerie::statistics {

namespace {

/// Of cos(angle)^(freedom - 1) from 0 to `end`.
double integral(double end, double freedom) {
  constexpr int intervals = 400;
  const double width = end / intervals;
  const auto f = [&](double angle) { return std::pow(std::cos(angle), freedom - 1); };
  double sum = 0;
  for (int k = 0; k < intervals; k += 2)
    sum += f(k * width) + 4 * f((k + 1) * width) + f((k + 2) * width);
  return sum * width / 3;
}

}  // namespace

double student_cdf(double t, double freedom) {
  // The whole integral in closed form: B(1/2, freedom/2) / 2.
  const double whole =
      std::sqrt(pi) / 2 * std::exp(std::lgamma(freedom / 2) - std::lgamma((freedom + 1) / 2));
  const double part = integral(std::atan(std::abs(t) / std::sqrt(freedom)), freedom) / whole / 2;
  return t < 0 ? 0.5 - part : 0.5 + part;
}

}  // namespace eerie::statistics
