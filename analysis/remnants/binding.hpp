#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/remnants/orbit.hpp"

namespace eerie::remnants {

/// Clumps that gravity holds together.
struct BoundGroup {
  PointMass sum;                     ///< mass and centre of mass of all members
  std::vector<std::size_t> members;  ///< indices of clumps, ascending
};

/// Groups of mutually bound clumps, the most massive first. A clump belongs to a group when its
/// energy relative to the group's centre of mass is negative:
///   mu v^2 / 2 - sum_k G m m_k / r_k < 0, mu = m M / (m + M), k over the group's clumps.
/// Groups grow round the first `cores` clumps (the remnants), the most massive first; then each
/// smaller clump joins the group that holds it most tightly, until none joins any more. Where
/// that gives fewer than two groups, the most massive clump left over begins one, so that a second
/// largest group exists whenever some clump is unbound. Unbound clumps are in no group.
/// `clumps` sorted from the most massive on; cost O(clumps^2) at worst.
std::vector<BoundGroup> bound_groups(std::span<const PointMass> clumps, std::size_t cores);

}  // namespace eerie::remnants
