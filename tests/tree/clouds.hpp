#pragma once

#include <string>
#include <vector>

#include "tests/support/particles.hpp"

namespace eerie::test {

inline constexpr const char* cloud_names[] = {"even", "clustered", "sheared", "far-flung"};

/// Clouds of points that impacts make, mean spacing of order 1 where they are dense: "even" a
/// ball, "clustered" dense knots in thin air, "sheared" a ball drawn into a blade, "far-flung" a
/// ball, clumps and single ejecta out to 1e4 (in metres, when the spacing is).
inline std::vector<Vec3> cloud(const std::string& name, std::size_t n) {
  Random random(11, n);
  const double radius = std::cbrt(3 * static_cast<double>(n) / (4 * pi));
  std::vector<Vec3> x = initial::packed_sphere("lattice", n, radius, random);
  for (Vec3& p : x) p += 0.2 * random.direction();
  if (name == "clustered") {
    const Vec3 knots[] = {{0, 0, 0}, {3, 1, 0}, {5, -2, 2}};
    for (std::size_t i = 0; i < n; ++i) {
      if (i % 10 == 0)
        x[i] = 4 * radius * std::cbrt(random.uniform()) * random.direction();
      else
        x[i] = 0.4 * x[i] + knots[i % 3];
    }
  }
  if (name == "sheared")
    for (Vec3& p : x) p = {4 * p.x + 3 * p.y, p.y, 0.4 * p.z};
  if (name == "far-flung")
    for (std::size_t i = 0; i < n; ++i) {
      if (i % 8 == 0) x[i] = 1e4 * random.uniform() * random.direction();
      if (i % 8 == 1) x[i] += Vec3{1e4, -3e3, 5e3};
      if (i % 8 == 2) x[i] += Vec3{-4e3, 2e3, 1e3};
    }
  return x;
}

}  // namespace eerie::test
