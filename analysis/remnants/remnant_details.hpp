#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <vector>

#include "analysis/remnants/orbit.hpp"
#include "analysis/remnants/origin.hpp"
#include "analysis/remnants/remnants.hpp"
#include "analysis/shapes/hull.hpp"
#include "analysis/shapes/shape_class.hpp"

namespace eerie::remnants {

/// Details of a remnant at the end of a run that do not decide the outcome class. They are too
/// costly for every look during the run.
struct RemnantDetails {
  shapes::ShapeClass shape_class = shapes::ShapeClass::spherical;
  double neck = 1;             ///< relative cross-section along the long axis (shape_class.hpp)
  shapes::HullBox box;         ///< around its particles, with their radius
  double bulk_density = 0;     ///< mass over the volume of its ellipsoid, kg/m^3
  std::optional<Vec3> spin;    ///< angular velocity, rad/s; nothing where it does not spin
  std::optional<double> tilt;  ///< angle between spin and shortest axis, 0 to 90 deg
  std::optional<OriginDepth> depth;  ///< nothing without the first snapshot
  std::optional<Orbit> orbit;        ///< about the most massive remnant; nothing for that one
};

/// Finds the details of the remnants of a snapshot, in the order of find_remnants(). `depths` are
/// those of the particles at the start, by id (initial_depths()), or empty where they are not
/// known.
std::vector<RemnantDetails> describe_remnants(const io::Snapshot& snapshot,
                                              std::span<const Remnant> remnants,
                                              std::span<const double> depths);

/// {"shape_class", "neck", "box_a_m", "box_b_m", "box_c_m", "box_b_over_a",
///  "bulk_density_kg_per_m3", "spin_axis_x", "spin_axis_y", "spin_axis_z", "spin_tilt_deg",
///  "origin_depth_mean_m", "origin_depth_p10_m", "origin_depth_p90_m", "orbit_pericentre_m",
/// "orbit_eccentricity", "orbit_semi_major_axis_m" (null when unbound), "orbit_period_h" (null when
/// unbound), "orbit_v_inf_m_per_s" (null when bound)}; null where a number is not known.
nlohmann::json to_json(const RemnantDetails& details);

}  // namespace eerie::remnants
