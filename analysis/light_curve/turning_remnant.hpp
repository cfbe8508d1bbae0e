#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "analysis/light_curve/light_curve.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::light_curve {

/// A remnant and its actual rotation.
struct TurningRemnant {
  SpinningBody body;
  std::optional<double> period, tilt;  ///< period, s; angle between rotation and shortest axis, rad
};

/// The remnant of this rank in mass. Throws InputError, which names `path`, where there are fewer
/// remnants.
TurningRemnant remnant_of(const io::Snapshot& snapshot, int rank,
                          const std::filesystem::path& path);

/// {"rank", "particles", "particle_radius_m", "a_m", "b_m", "c_m", "b_over_a", "c_over_a",
/// "spin_period_h", "spin_from_shortest_axis_deg"}; the last two are null where it does not turn.
nlohmann::json to_json(const TurningRemnant& remnant, int rank);

}  // namespace eerie::light_curve
