#pragma once

#include <cmath>
#include <cstdint>

#include "solver/base/constants.hpp"
#include "solver/base/vec3.hpp"

namespace eerie {

/// The generator splitmix64 (Steele, Lea & Flood 2014). It gives the same stream on every platform,
/// which the distributions of <random> do not. The scene gives the seed; each purpose has its own
/// stream.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream) : state_(seed * 0x9e3779b97f4a7c15ULL + stream) {
    next();
  }

  /// A number, uniform in [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  double uniform(double lo, double hi) { return lo + (hi - lo) * uniform(); }

  /// A direction, uniform on the unit sphere.
  Vec3 direction() {
    const double z = uniform(-1, 1), azimuth = uniform(0, 2 * pi), s = std::sqrt(1 - z * z);
    return {s * std::cos(azimuth), s * std::sin(azimuth), z};
  }

 private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace eerie
