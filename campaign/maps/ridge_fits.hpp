#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/paper/threshold.hpp"
#include "campaign/maps/impact_runs.hpp"
#include "campaign/text/table.hpp"
#include "db/views/map_points.hpp"

namespace eerie::maps {

/// Comparable runs and the fit of their ridge.
struct RidgeFit {
  ComparableRuns group;
  std::variant<paper::Threshold, paper::TooFewForThreshold> fit;
  const paper::Threshold* found() const { return std::get_if<paper::Threshold>(&fit); }
};

/// Fits the ridges of all groups of runs with this number of particles per target, or with any.
std::vector<RidgeFit> fit_ridges(const ImpactRuns& runs,
                                 std::optional<std::int64_t> particles_per_target);

/// A table of the rows of a ridge, for programs and for people.
text::Table table_of_rows(const paper::Threshold& threshold);

/// {"q", "phi_d_deg", "particles_per_target", "settings", "settings_number", "runs", "impacts",
///  "paper_cm_per_s"} with the constants and "rows", or with "not_enough_data".
nlohmann::json to_json(const RidgeFit& fit);

/// A CSV table with one line per group and its constants. Fields are empty where there are too few
/// runs.
std::string ridges_csv(const std::vector<RidgeFit>& fits);

/// Draws the map of the one fitted ridge, with its own curve instead of the paper's. Throws
/// InputError, which lists the choices, where there is none, or several.
void draw_ridge(const std::filesystem::path& file, const db::Connection& connection,
                const std::vector<RidgeFit>& fits);

}  // namespace eerie::maps
