#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/remnants/orbit.hpp"

namespace eerie::remnants {

/// A group of clumps that gravity binds to each other.
struct BoundGroup {
  PointMass sum;                     ///< mass and centre of mass of all members
  std::vector<std::size_t> members;  ///< indices of clumps, ascending
};

/// Finds the groups of mutually bound clumps, the most massive first. A clump belongs to a group
/// when its energy relative to the group's centre of mass is negative:
/// mu v^2 / 2 - sum_k G m m_k / r_k < 0, where mu = m M / (m + M) and k runs over the group.
/// Groups grow around the first `cores` clumps (the remnants), the most massive first. Then each
/// smaller clump joins the group that binds it most tightly, until no clump joins any more. Where
/// this gives fewer than two groups, the most massive remaining clump begins one. So a second
/// largest group exists whenever some clump is unbound. Other unbound clumps are in no group.
/// `clumps` must be sorted, the most massive first. The cost is at most O(clumps^2).
std::vector<BoundGroup> bound_groups(std::span<const PointMass> clumps, std::size_t cores);

}  // namespace eerie::remnants
