#pragma once

#include <span>
#include <string>

#include "analysis/remnants/remnants.hpp"

namespace eerie::remnants {

/// Says why remnants will still meet each other, with the numbers of the most massive such pair.
/// The text is empty where none will. A pair will meet when both are in one bound group, or when
/// their orbit is bound or closing and its pericentre is below the sum of their longest semi-axes.
/// Remnants of at most `fragment` of all mass (end.settled.fall_back) do not count: they change
/// little when they fall back, and finer runs have more of them. This function does not see changes
/// of shape within one remnant, which takes two snapshots.
std::string unsettled_reason(std::span<const Remnant> remnants, double fragment);
/// The same about a primary, where orbits of pairs say nothing: empty for a single remnant.
std::string unsettled_reason_in_tide(std::span<const Remnant> remnants, double fragment);

/// Whether some pair of remnants, fragments excluded, is on its way to a contact.
bool will_meet(std::span<const Remnant> remnants, double fragment);

}  // namespace eerie::remnants
