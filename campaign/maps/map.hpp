#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/diagrams/phase_diagram.hpp"
#include "db/views/map_points.hpp"
#include "db/views/query.hpp"

namespace eerie::maps {

/// The maps of these points, one per mass ratio, friction angle and settings.
std::vector<diagrams::PhaseDiagram> phase_diagrams(const std::vector<db::MapPoint>& points);
std::vector<diagrams::PhaseDiagram> phase_diagrams(const db::Connection& connection,
                                                   const db::MapFilter& filter);

/// The label of a map in names of files: "q1-phi40-n1000". Where another map of `all` has the same
/// label, the number of the settings follows, "-s3".
std::string map_label(const diagrams::PhaseDiagram& diagram,
                      const std::vector<diagrams::PhaseDiagram>& all);

/// Draws the pictures of a sweep beside its database, "<database>-<sweep>-b-over-a.png" and ".svg",
/// and writes their numbers as ".csv". The name has the sweep only where that differs from the
/// database, and the label of the map where there are several maps. It draws pictures that are
/// missing or older than the newest result. Returns the paths of the pictures.
std::vector<std::filesystem::path> draw_sweep_maps(const db::Connection& connection,
                                                   std::int64_t sweep,
                                                   const std::string& sweep_name);

struct NamedMaps {
  db::MapFilter filter = {};
  std::vector<diagrams::MapQuantity> quantities = {diagrams::MapQuantity::b_over_a};
  /// .png, .svg, .pdf, or .csv for the numbers alone.
  std::vector<std::filesystem::path> files = {};
};
/// Throws InputError for a file of another kind.
void require_map_files(const std::vector<std::filesystem::path>& files, const std::string& option);
/// Throws InputError, which begins with `option`, for jobs whose maps do not make one figure.
/// Callers use it before hours of work.
void require_one_figure(const std::vector<db::NewJob>& jobs, const std::string& option);
/// Draws the map of all points that pass the filter into each file, writes its numbers beside it,
/// and returns the files. Throws InputError where the filter leaves several settings, or several
/// maps of several quantities. A table may have several settings.
std::vector<std::filesystem::path> draw_named_maps(const db::Connection& connection,
                                                   const NamedMaps& request);

}  // namespace eerie::maps
