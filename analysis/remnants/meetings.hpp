#pragma once

#include <span>
#include <string>

#include "analysis/remnants/remnants.hpp"

namespace eerie::remnants {

/// Why the remnants will still change by meeting each other, with the numbers of the most massive
/// such pair; empty when none will. A pair will meet when both are in one bound group, or when
/// their orbit is bound or closing and its pericentre is below the sum of their half longest axes.
/// Remnants of no more than `fragment` of all mass (end.settled.fall_back) do not count: what falls
/// back changes little, and finer runs have more of them.
/// Shapes that still change within one remnant are not seen here: that takes two snapshots.
std::string unsettled_reason(std::span<const Remnant> remnants, double fragment);

/// Whether some pair of remnants, no fragments, is on its way to a contact.
bool will_meet(std::span<const Remnant> remnants, double fragment);

}  // namespace eerie::remnants
