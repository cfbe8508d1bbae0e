#pragma once

#include <nlohmann/json_fwd.hpp>

#include "db/views/map_points.hpp"

namespace eerie::serve {

/// The maps of the database: {"maps": [{"q", "phi_d_deg", "particles_per_target", "settings",
/// "fidelity", "jobs", "done"}]}.
nlohmann::json map_names_json(const db::Connection& connection);

/// One map in all quantities of `eerie map`, with colours. It has axes with their edges; cells with
/// counts, means, standard deviations and classes over their seeds; scales with ticks and colours;
/// and the classes. Throws InputError where the filter leaves no map, or several.
nlohmann::json map_json(const db::Connection& connection, const db::MapFilter& filter);

/// The fit v sin(theta) = constant to the elongated remnants of a map: {"constant", "low", "high",
/// "half_width"}, or {"reason"} where there is none. Its bootstrap takes a while.
nlohmann::json ridge_json(const db::Connection& connection, const db::MapFilter& filter);

}  // namespace eerie::serve
