#pragma once

#include <string>
#include <vector>

#include "campaign/maps/ridge_fits.hpp"

namespace eerie::maps {

/// The lines about a ridge, for people: the runs behind it, and its constants beside the paper's or
/// why there are none. `all` are the fits among which the name must be unique.
std::string ridge_text(const RidgeFit& fit, const std::vector<RidgeFit>& all);

}  // namespace eerie::maps
