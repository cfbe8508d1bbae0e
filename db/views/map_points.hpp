#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "db/store/connection.hpp"

namespace eerie::db {

/// One point of a map: all jobs with this speed, this angle and the same settings. They differ in
/// their seeds. Results of another solver version count like others.
struct MapPoint {
  double q = 0, phi_d_deg = 0, v_imp_cm_per_s = 0, theta_imp_deg = 0, v_over_v_esc = 0;
  std::int64_t particles_per_target = 0;
  std::int64_t settings = 0;  ///< db/jobs/job_settings.hpp
  std::string fidelity = {};  ///< empty where the settings have no name
  std::int64_t jobs = 0, done = 0, failed = 0, cancelled = 0;
  std::vector<std::string> running = {};  ///< hashes of the running jobs
  /// The number of results. `stale` of them come from another solver version, and `unsettled` have
  /// remnants that will meet again.
  std::int64_t results = 0, stale = 0, unsettled = 0;
  /// The numbers of the results that have them. b/a, c/a and period are those of the largest
  /// remnant.
  std::vector<double> b_over_a = {}, c_over_a = {}, period_h = {}, m_lr_over_m_total = {},
                      n_eer = {};
  std::int64_t largest_is_eer = 0, smaller_is_eer = 0;  ///< number of results with this property
  std::map<std::string, std::int64_t> classes = {};     ///< number of results of each class

  /// The most frequent class; the first by name among equals. Empty without results.
  std::string outcome_class() const;
  /// The fraction of the results whose largest remnant is an EER; 0 without results.
  double p_largest_eer() const { return share(largest_is_eer); }
  double share(std::int64_t of_results) const {
    return results == 0 ? 0 : static_cast<double>(of_results) / static_cast<double>(results);
  }
};

struct MapFilter {
  std::optional<std::int64_t> sweep = {};
  std::optional<double> q = {}, phi_d_deg = {};
  std::optional<std::int64_t> particles_per_target = {};
  std::optional<std::string> fidelity = {};
  std::optional<std::int64_t> settings = {};
};

/// The points that pass a filter, ordered by q, phi_d, particles, settings, then v_imp and
/// theta_imp.
std::vector<MapPoint> map_points(const Connection& connection, const MapFilter& filter);

/// A map that a database contains.
struct MapName {
  double q = 0, phi_d_deg = 0;
  std::int64_t particles_per_target = 0, settings = 0;
  std::string fidelity = {};  ///< empty where the settings have no name
  std::int64_t jobs = 0, done = 0;
};
/// The maps of a database, in the order of map_points().
std::vector<MapName> map_names(const Connection& connection);

}  // namespace eerie::db
