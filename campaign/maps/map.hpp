#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/diagrams/phase_diagram.hpp"
#include "db/views/map_points.hpp"
#include "db/views/query.hpp"

namespace eerie::maps {

/// The maps that these points make: one per mass ratio, friction angle and settings.
std::vector<diagrams::PhaseDiagram> phase_diagrams(const std::vector<db::MapPoint>& points);
std::vector<diagrams::PhaseDiagram> phase_diagrams(const db::Connection& connection,
                                                   const db::MapFilter& filter);

/// "q1-phi40-n1000", for names of files; "-s3" behind, the settings, where another of `all` has the
/// same.
std::string map_label(const diagrams::PhaseDiagram& diagram,
                      const std::vector<diagrams::PhaseDiagram>& all);

/// The pictures of a sweep beside its database, "<database>-<sweep>-b-over-a.png" and ".svg" (the
/// sweep only where it has another name; the map's label behind where it has several maps), and
/// their numbers as ".csv". Draws those that are missing or older than the newest result. Returns
/// the paths of the pictures.
std::vector<std::filesystem::path> draw_sweep_maps(const db::Connection& connection,
                                                   std::int64_t sweep,
                                                   const std::string& sweep_name);

struct NamedMaps {
  db::MapFilter filter = {};
  std::vector<diagrams::MapQuantity> quantities = {diagrams::MapQuantity::b_over_a};
  std::vector<std::filesystem::path> files = {};  ///< .png, .svg, .pdf; .csv: the numbers alone
};
/// Throws InputError for a file of another kind.
void require_map_files(const std::vector<std::filesystem::path>& files, const std::string& option);
/// What is asked for must be possible before hours of work. Throws InputError, which begins with
/// `option`, for jobs whose maps are not one figure.
void require_one_figure(const std::vector<db::NewJob>& jobs, const std::string& option);
/// Draws one figure of all that the filter leaves into each file, with its numbers beside it, and
/// returns what was written. Throws InputError where the filter leaves several settings, or several
/// maps of several quantities; a table may hold several settings.
std::vector<std::filesystem::path> draw_named_maps(const db::Connection& connection,
                                                   const NamedMaps& request);

}  // namespace eerie::maps
