#pragma once

#include <array>
#include <vector>

namespace eerie::statistics {

/// A probability over two variables: logit P is a polynomial of second degree. So P > 1/2 is inside
/// an ellipse, a band or a wedge, or nowhere.
struct LogisticSurface {
  static constexpr std::size_t terms = 6;  ///< 1, x, y, x^2, x y, y^2
  std::array<double, terms> coefficients{};

  double p(double x, double y) const;
};

/// Repeated trials at one place.
struct Trials {
  double x = 0, y = 0;
  double hits = 0, runs = 0;
};

/// The surface that maximises likelihood times Jeffreys' prior (Firth 1993, Biometrika 80, 27).
/// That has a finite answer where hits and misses are separated as well, and with few hits.
/// Variables should be of order one. Trials without runs are ignored; with fewer than six places,
/// or places on one curve of second degree, what they leave open stays flat.
LogisticSurface fit_logistic_surface(const std::vector<Trials>& trials);

}  // namespace eerie::statistics
