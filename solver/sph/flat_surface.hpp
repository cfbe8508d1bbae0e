#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "solver/base/constants.hpp"

namespace eerie::sph {

/// The density sum_j m W_ij of a particle in matter of density 1 that fills one side of a plane, as
/// a function of the length of its first moment sum_j m W_ij x_ij/h. Both depend on its depth below
/// the plane.
template <class Kernel>
class FlatSurface {
 public:
  FlatSurface() {
    // The kernel projected on the normal, P(z) = 2 pi int W s ds with s^2 = r^2 - z^2, by the
    // midpoint rule.
    double inside = 0.5, moment = 0;
    std::array<double, depths + 1> m{}, w{};
    for (int k = depths; k-- > 0;) {
      const double z = (k + 0.5) * step;
      double projected = 0;
      for (int n = 0; n < 256; ++n) {
        const double r = z + (n + 0.5) * (2 - z) / 256;
        projected += 2 * pi * Kernel::normalisation * Kernel::w(r) * r * (2 - z) / 256;
      }
      moment += projected * z * step;
      m[static_cast<std::size_t>(k)] = moment;
      w[static_cast<std::size_t>(k)] = projected * step;
    }
    moments_ = m;
    densities_[0] = inside;
    for (std::size_t k = 0; k < depths; ++k) densities_[k + 1] = densities_[k] + w[k];
  }

  /// The density of the particle whose first moment is `moment` >= 0. For a larger moment than any,
  /// it is that of a particle on the plane.
  double density(double moment) const {
    // The moment falls with depth.
    const auto deeper =
        std::upper_bound(moments_.begin(), moments_.end(), moment, std::greater<>());
    if (deeper == moments_.begin()) return densities_[0];
    const auto k = static_cast<std::size_t>(deeper - moments_.begin());
    const double above = moments_[k - 1], below = moments_[std::min(k, moments_.size() - 1)];
    const double share = above > below ? (above - moment) / (above - below) : 0;
    return densities_[k - 1] +
           share * (densities_[std::min(k, moments_.size() - 1)] - densities_[k - 1]);
  }

 private:
  static constexpr int depths = 128;
  static constexpr double step = 2.0 / depths;
  std::array<double, depths + 1> moments_{}, densities_{};
};

template <class Kernel>
double flat_density(double moment) {
  static const FlatSurface<Kernel> surface;
  return surface.density(moment);
}

}  // namespace eerie::sph
