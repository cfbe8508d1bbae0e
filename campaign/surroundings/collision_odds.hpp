#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/text/table.hpp"
#include "db/views/map_points.hpp"

namespace eerie::surroundings {

/// How often a collision in a swarm leaves a largest remnant with b/a < 0.3.
struct CollisionOdds {
  double q = 0, phi_d_deg = 0;     ///< the map that it rests on
  std::string fidelity = {};       ///< empty where the settings have no name
  double dispersion_cm_per_s = 0;  ///< of one component of the relative velocity far away
  double median_v_imp_cm_per_s = 0;
  double p_eer = 0;
  /// One standard error of p_eer, from the scatter between seeds. Impacts with one result count as
  /// certain.
  double p_eer_error = 0;
  double mapped = 0;  ///< fraction of the collisions inside the map; p_eer counts none outside
};

/// The odds of each map among `points` (one per q, phi_d and settings) at each dispersion. Impact
/// angles are isotropic, speeds Maxwellian and focused by gravity. A collision has the outcome of
/// the nearest impact that has a result.
std::vector<CollisionOdds> collision_odds(const std::vector<db::MapPoint>& points,
                                          const std::vector<double>& dispersions_cm_per_s);

/// From 1 to 100 cm/s.
std::vector<double> usual_dispersions_cm_per_s();

text::Table table_of_odds(const std::vector<CollisionOdds>& odds);

/// Draws p_eer over the dispersion, one curve per map, with bands of one standard error. Throws as
/// run_gnuplot() does.
void draw_odds(const std::filesystem::path& path, const std::vector<CollisionOdds>& odds);

}  // namespace eerie::surroundings
