#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/base/vec3.hpp"

namespace eerie::remnants {

/// The linking length of friends-of-friends, in smoothing lengths (Sugiura et al. 2019).
inline constexpr double linking_length_over_h = 1.5;

/// The memory indices of the particles of one clump, sorted by particle id.
using Clump = std::vector<std::uint32_t>;

/// Finds clumps by friends-of-friends: particles no further apart than `linking_length` (m, > 0)
/// belong to one clump. Every particle is in exactly one clump. Clumps are sorted by their number
/// of particles, then by their smallest id, so the result does not depend on the memory order. The
/// cost is O(N), by a hashed grid, which has no borders that ejecta could leave.
std::vector<Clump> friends_of_friends(std::span<const Vec3> x, std::span<const std::uint32_t> id,
                                      double linking_length);

}  // namespace eerie::remnants
