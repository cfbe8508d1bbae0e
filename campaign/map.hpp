#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/phase_diagram.hpp"
#include "campaign/auto_fidelity.hpp"
#include "db/map_points.hpp"
#include "db/query.hpp"

namespace eerie {

/// The maps that a database can draw: one per mass ratio, friction angle and settings.
std::vector<PhaseDiagram> phase_diagrams(const db::Connection& connection,
                                         const db::MapFilter& filter);

/// "q1-phi40-n1000", for names of files; "-s3" behind, the settings, where another of `all` has the
/// same.
std::string map_label(const PhaseDiagram& diagram, const std::vector<PhaseDiagram>& all);

/// The maps of an automatic choice of fidelity: each cell says what it rests on, and is heavily
/// framed where it is in doubt.
std::vector<PhaseDiagram> phase_diagrams(const AutoFidelity& campaign);

/// The pictures of a sweep beside its database, "<database>-<sweep>-b-over-a.png" and ".svg" (the
/// sweep only where it has another name; "-q1-phi40-n5000" behind where it has several maps).
/// Draws those that are missing or older than the newest result. Returns their paths.
std::vector<std::filesystem::path> draw_sweep_maps(const db::Connection& connection,
                                                   std::int64_t sweep,
                                                   const std::string& sweep_name);

/// The same maps into files that the user named; a sweep with several maps is refused.
void draw_named_maps(const db::Connection& connection, const db::MapFilter& filter,
                     const std::vector<std::filesystem::path>& files);

}  // namespace eerie
