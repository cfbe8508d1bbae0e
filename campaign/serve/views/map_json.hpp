#pragma once

#include <nlohmann/json_fwd.hpp>

#include "db/views/map_points.hpp"

namespace eerie::serve {

/// {"maps": [{"q", "phi_d_deg", "particles_per_target", "settings", "fidelity", "jobs", "done"}]}:
/// the maps that the database holds.
nlohmann::json map_names_json(const db::Connection& connection);

/// One map in all quantities of `eerie map`, colours included: axes with their edges, cells with
/// counts, means, standard deviations and classes over their seeds, scales with ticks and colours,
/// the classes. Throws InputError where the filter leaves no map, or several.
nlohmann::json map_json(const db::Connection& connection, const db::MapFilter& filter);

/// The curve v sin(theta) = constant that is fitted to a map's elongated remnants: {"constant",
/// "low", "high", "half_width"}, or {"reason"} why there is none. Its bootstrap takes a while.
nlohmann::json ridge_json(const db::Connection& connection, const db::MapFilter& filter);

}  // namespace eerie::serve
