#pragma once

#include <algorithm>
#include <limits>

#include "solver/base/vec3.hpp"

namespace eerie {

/// A box along the axes. It is empty until it includes a point.
struct Box {
  Vec3 lo{inf, inf, inf}, hi{-inf, -inf, -inf};

  void include(const Vec3& p) {
    for (int k = 0; k < 3; ++k) lo[k] = std::min(lo[k], p[k]), hi[k] = std::max(hi[k], p[k]);
  }
  void include(const Box& b) { include(b.lo), include(b.hi); }
  Vec3 centre() const { return 0.5 * (lo + hi); }
  Vec3 extent() const { return hi - lo; }

 private:
  static constexpr double inf = std::numeric_limits<double>::max();
};

inline double distance2(const Box& b, const Vec3& p) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double d = std::max({b.lo[k] - p[k], 0.0, p[k] - b.hi[k]});
    sum += d * d;
  }
  return sum;
}

inline double distance2(const Box& a, const Box& b) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double d = std::max({a.lo[k] - b.hi[k], 0.0, b.lo[k] - a.hi[k]});
    sum += d * d;
  }
  return sum;
}

}  // namespace eerie
