#pragma once

#include <cstring>
#include <vector>

#include "solver/base/constants.hpp"
#include "solver/material/of_bodies.hpp"
#include "solver/particles/state.hpp"
#include "solver/tree/neighbour_list.hpp"
#include "solver/tree/places.hpp"

// What lies around particles, by plain sums over volumes at rest, in whole packs.

namespace eerie::step {

/// What lies around the particles of a bucket. Places are in units of one h for all.
struct Around {
  tree::Places at;
  /// The inverse of the reference density of each, m^3/kg; empty where all have one.
  std::vector<float> per_density;

  void fill(const tree::NeighbourList& lists, std::size_t bucket, const particles::State& state,
            const material::OfBodies& materials) {
    const tree::BucketList& list = lists[bucket];
    const Vec3 origin = state.x[bucket * tree::bucket_size];
    at.fill(list.rows.size(), [&](std::size_t place) {
      const Vec3& x = state.x[list.rows[place]];
      return (list.as_seen(place, x, lists.images()) - origin) / state.h;
    });
    per_density.clear();
    if (!materials.has_two_densities()) return;
    for (const std::uint32_t j : list.rows)
      per_density.push_back(static_cast<float>(1 / materials.reference_density(state.body[j])));
    per_density.resize(at.x.size());
  }
};

/// How particle k of a bucket is surrounded.
template <class Kernel>
struct Surroundings {
  const Around& around;
  std::size_t k;
  double rho0;        ///< of the particle, kg/m^3
  double per_volume;  ///< m/h^3 and the kernel's normalisation, kg/m^3
  float finer;        ///< units of place over its own h

  /// Those of particle `number` of the bucket that begins at index `begin`, with h in metres.
  Surroundings(const Around& places, std::size_t begin, std::size_t number,
               const particles::State& state, const material::OfBodies& materials, double h)
      : around(places),
        k(number),
        rho0(materials.reference_density(state.body[begin + k])),
        per_volume(state.mass * Kernel::normalisation / cubed(h)),
        finer(static_cast<float>(state.h / h)) {}

  /// Calls visit(first) for each pack of which something may lie within the kernel's reach, 2 h.
  template <class Visit>
  void visit_packs(Visit&& visit) const {
    const tree::Places& at = around.at;
    constexpr float reach2 = 4.0001f;  // a little more than 4, for what rounding does to 1/r
    at.visit_packs_near(at.x[k], at.y[k], at.z[k], reach2 / (finer * finer), visit);
  }
  tree::Places::Offsets offsets(std::size_t first) const {
    const tree::Places& at = around.at;
    auto [x, y, z] = at.offsets(first, at.x[k], at.y[k], at.z[k]);
    if (!around.per_density.empty()) x *= finer, y *= finer, z *= finer;
    return {x, y, z};
  }
  /// A particle of other density takes another volume: `kernel` in the units of this one.
  Pack<float> weighed(std::size_t first, const Pack<float>& kernel) const {
    if (around.per_density.empty()) return kernel;
    Pack<float> per_density;
    std::memcpy(&per_density, around.per_density.data() + first, sizeof per_density);
    return kernel * per_density * static_cast<float>(rho0);
  }
};

/// The sum of the lanes.
inline double total(const Pack<float>& pack) {
  double sum = 0;
  for (int l = 0; l < lanes<float>; ++l) sum += double{pack[l]};
  return sum;
}

}  // namespace eerie::step
