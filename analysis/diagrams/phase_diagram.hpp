#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace eerie::diagrams {

/// done: a settled result; unsettled: a result whose remnants will meet again; failed and
/// pending: no result.
enum class CellState { done, unsettled, failed, pending };

/// One impact of a map. Numbers are means over its seeds.
struct PhaseCell {
  double v_imp_cm_per_s = 0;
  double theta_imp_deg = 0;
  CellState state = CellState::pending;
  std::optional<double> b_over_a = {};  ///< of the largest remnant; read where there is a result
  std::string outcome = {};   ///< class name (outcome.hpp); empty where there is no result
  bool smaller_eer = false;   ///< some remnant but the largest is an EER
  std::string fidelity = {};  ///< settings that the result rests on; empty: told once for all cells
  std::size_t seeds = 1;      ///< runs that it is the mean of
  bool in_doubt = false;      ///< the runs do not agree as surely as was asked
  bool stale = false;         ///< some of the runs are of another solver version
  double class_share = 1;     ///< fraction of the runs that are of the class
  std::optional<double> c_over_a = {}, period_h = {};  ///< of the largest remnant
  std::optional<double> m_lr_over_m_total = {}, n_eer = {};
  std::optional<double> p_largest_eer =
      {};  ///< fraction of the runs whose largest remnant has b/a < 0.3

  bool has_result() const { return state == CellState::done || state == CellState::unsettled; }
};

/// Impacts over speed and angle at one mass ratio and friction angle.
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

/// What a map shows: numbers of the largest remnant, mass of the largest bound group over that of
/// both bodies, the most frequent class, EERs among all remnants, and the fraction of runs whose
/// largest remnant is one.
enum class MapQuantity { b_over_a, c_over_a, m_lr, period, outcome, n_eer, p_largest_eer };

/// A map, or several as panels of one figure: one quantity for each diagram, or one diagram by each
/// quantity. Panels share their axes, and their colours where the quantity is one.
struct PhaseFigure {
  std::vector<PhaseDiagram> diagrams;
  std::vector<MapQuantity> quantities = {MapQuantity::b_over_a};
};
inline constexpr std::size_t most_panels = 24;

/// Draws the figure by gnuplot and installs it atomically; the extension decides: .png, .svg, .pdf.
/// Throws InputError (no cells, two cells in one place, other extension, unknown class, several
/// diagrams by several quantities, too many panels) and EnvironmentError (gnuplot is missing: which
/// package to install; gnuplot or the disk failed).
void draw_phase_figure(const std::filesystem::path& path, const PhaseFigure& figure);

/// b/a alone.
void draw_phase_diagram(const std::filesystem::path& path, const PhaseDiagram& diagram);

}  // namespace eerie::diagrams
