#pragma once

#include <cstring>
#include <vector>

#include "solver/base/simd.hpp"
#include "solver/base/vec3.hpp"

namespace eerie::tree {

/// Positions as floats, relative to a nearby point. Components lie side by side, so that the
/// distances of a whole pack are computed at once.
struct Places {
  std::vector<float> x, y, z;

  void clear() { x.clear(), y.clear(), z.clear(); }
  void push(const Vec3& d) {
    x.push_back(static_cast<float>(d.x));
    y.push_back(static_cast<float>(d.y));
    z.push_back(static_cast<float>(d.z));
  }
  /// Fills up the last pack with positions far away.
  void pad() {
    while (x.size() % lanes<float> != 0) push({1e9, 1e9, 1e9});
  }
  struct Offsets {
    Pack<float> x, y, z;
  };
  /// The pack that begins at index `first`, relative to a position.
  Offsets offsets(std::size_t first, float at_x, float at_y, float at_z) const {
    Offsets d;
    std::memcpy(&d.x, x.data() + first, sizeof d.x);
    std::memcpy(&d.y, y.data() + first, sizeof d.y);
    std::memcpy(&d.z, z.data() + first, sizeof d.z);
    d.x -= at_x, d.y -= at_y, d.z -= at_z;
    return d;
  }
  /// The squared distances from a position of the pack that begins at index `first`.
  Pack<float> distance2(std::size_t first, float at_x, float at_y, float at_z) const {
    const auto [dx, dy, dz] = offsets(first, at_x, at_y, at_z);
    return dx * dx + dy * dy + dz * dz;
  }
};

}  // namespace eerie::tree
