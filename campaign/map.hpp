#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/phase_diagram.hpp"
#include "db/query.hpp"

namespace eerie {

/// The maps of b/a that a database can draw: one per mass ratio, friction angle and resolution.
std::vector<PhaseDiagram> phase_diagrams(const db::Connection& connection,
                                         const db::MapFilter& filter);

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
