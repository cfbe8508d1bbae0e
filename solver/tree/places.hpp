#pragma once

#include <bit>
#include <cstring>
#include <vector>

#include "solver/base/simd/search.hpp"
#include "solver/base/vec3.hpp"

namespace eerie::tree {

/// Positions as floats, relative to a nearby point. Components lie side by side, so that the
/// distances of a whole pack are computed at once. Neighbours in memory are neighbours in space, so
/// most packs are out of reach of any one point as a whole: `boxes` tells.
struct Places {
  std::vector<float> x, y, z;
  /// The boxes around the packs, one for each lane of one of these.
  struct Boxes {
    Pack<float> lo_x, hi_x, lo_y, hi_y, lo_z, hi_z;
  };
  std::vector<Boxes> boxes;

  /// Makes `count` places, of which number k is place(k), and fills up the last pack with some far
  /// away.
  template <class Place>
  void fill(std::size_t count, Place&& place) {
    x.resize(count), y.resize(count), z.resize(count);
    float *to_x = x.data(), *to_y = y.data(), *to_z = z.data();
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3 d = place(k);
      to_x[k] = static_cast<float>(d.x), to_y[k] = static_cast<float>(d.y),
      to_z[k] = static_cast<float>(d.z);
    }
    const std::size_t packs = (count + lanes<float> - 1) / lanes<float>;
    for (std::vector<float>* c : {&x, &y, &z}) c->resize(packs * lanes<float>, 1e9f);
    fit_boxes();
  }
  /// Calls visit(first) for each pack in whose box something may be nearer than sqrt(r2). Rounding
  /// is monotonic, so no place whose distance2() is below r2 is left out.
  template <class Visit>
  void visit_packs_near(float at_x, float at_y, float at_z, float r2, Visit&& visit) const {
    for (std::size_t g = 0; g < boxes.size(); ++g) {
      const Boxes& b = boxes[g];
      const Pack<float> dx = positive_part(b.lo_x - at_x) + positive_part(at_x - b.hi_x),
                        dy = positive_part(b.lo_y - at_y) + positive_part(at_y - b.hi_y),
                        dz = positive_part(b.lo_z - at_z) + positive_part(at_z - b.hi_z);
      for (std::uint32_t near = lanes_below(Pack<float>(dx * dx + dy * dy + dz * dz), r2);
           near != 0; near &= near - 1)
        visit((g * lanes<float> + static_cast<std::size_t>(std::countr_zero(near))) * lanes<float>);
    }
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
    const auto [px, py, pz] = offsets(first, 0, 0, 0);
    const Pack<float> dx = at_x - px, dy = at_y - py, dz = at_z - pz;  // loads and subtracts in one
    return dx * dx + dy * dy + dz * dz;
  }

 private:
  void fit_boxes() {
    const std::size_t packs = x.size() / lanes<float>;
    boxes.resize((packs + lanes<float> - 1) / lanes<float>);
    const Pack<float> nowhere = splat(2e9f);
    for (Boxes& b : boxes) b = {nowhere, nowhere, nowhere, nowhere, nowhere, nowhere};
    for (std::size_t pack = 0; pack < packs; ++pack) {
      Boxes& b = boxes[pack / lanes<float>];
      const int l = static_cast<int>(pack % lanes<float>);
      const auto [px, py, pz] = offsets(pack * lanes<float>, 0, 0, 0);
      b.lo_x[l] = least(px), b.lo_y[l] = least(py), b.lo_z[l] = least(pz);
      b.hi_x[l] = -least(-px), b.hi_y[l] = -least(-py), b.hi_z[l] = -least(-pz);
    }
  }
  /// The least of the lanes.
  static float least(Pack<float> p) {
    alignas(vector_bytes) float a[lanes<float>];
    std::memcpy(a, &p, sizeof a);
    for (int n = lanes<float> / 2; n > 0; n /= 2)
      for (int l = 0; l < n; ++l) a[l] = a[l + n] < a[l] ? a[l + n] : a[l];
    return a[0];
  }
};

}  // namespace eerie::tree
