#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace eerie {

/// done: a settled result; unsettled: a result whose remnants will meet again; failed and
/// pending: no result.
enum class CellState { done, unsettled, failed, pending };

/// One impact of a map.
struct PhaseCell {
  double v_imp_cm_per_s = 0;
  double theta_imp_deg = 0;
  CellState state = CellState::pending;
  double b_over_a = 0;        ///< of the largest remnant; read for done and unsettled only
  std::string outcome = {};   ///< class name (outcome.hpp); empty where there is no result
  bool eer = false;           ///< some remnant of at least 100 particles has b/a < 0.3
  std::string fidelity = {};  ///< settings that the result rests on; empty: told once for all cells
  std::size_t seeds = 1;      ///< runs that it is the mean of
  bool in_doubt = false;      ///< the runs do not agree as surely as was asked
};

/// A map of b/a over impact speed and angle at one mass ratio and friction angle.
struct PhaseDiagram {
  double q = 1;
  double phi_d_deg = 40;
  std::int64_t particles_per_target = 0;  ///< 0: differs from cell to cell
  double v_esc_cm_per_s = 0;  ///< mutual escape speed at contact: the upper axis; 0: none
  std::optional<double> threshold_cm_per_s;  ///< draws the curve v sin(theta) = threshold
  std::vector<PhaseCell> cells;              ///< any order; at most one per (v, theta)
  std::string fidelity = {};                 ///< empty: the settings have no name
  std::int64_t settings = 0;                 ///< what a database calls them; 0: not known
};

/// Draws the map by gnuplot and installs it atomically; the extension decides: .png, .svg, .pdf.
/// Throws InputError (no cells, two cells in one place, other extension, unknown class) and
/// EnvironmentError (gnuplot is missing: which package to install; gnuplot or the disk failed).
void draw_phase_diagram(const std::filesystem::path& path, const PhaseDiagram& diagram);

/// The numbers of the map, one line per cell sorted by angle and speed, units in the header.
std::string phase_diagram_csv(const PhaseDiagram& diagram);

}  // namespace eerie
