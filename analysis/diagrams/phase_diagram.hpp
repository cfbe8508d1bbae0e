#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/isolines.hpp"

namespace eerie::diagrams {

/// `done` is a settled result, `unsettled` a result whose remnants will meet again. `failed` and
/// `pending` have no result.
enum class CellState { done, unsettled, failed, pending };

/// One impact of a map. Its numbers are means over its seeds.
struct PhaseCell {
  double v_imp_cm_per_s = 0;
  double theta_imp_deg = 0;
  CellState state = CellState::pending;
  /// Of the largest remnant; has a meaning where there is a result.
  std::optional<double> b_over_a = {};
  std::string outcome = {};   ///< class name (outcome.hpp); empty where there is no result
  bool smaller_eer = false;   ///< some remnant other than the largest is an EER
  std::string fidelity = {};  ///< of the runs behind the result; empty where all cells share it
  std::size_t seeds = 1;      ///< number of runs in the means
  bool in_doubt = false;      ///< the runs do not agree as surely as asked
  bool stale = false;         ///< some of the runs are of another solver version
  double class_share = 1;     ///< fraction of the runs that have this class
  std::optional<double> c_over_a = {}, period_h = {};  ///< of the largest remnant
  std::optional<double> m_lr_over_m_total = {}, n_eer = {};
  /// Fraction of the runs whose largest remnant has b/a < 0.3.
  std::optional<double> p_largest_eer = {};

  bool has_result() const { return state == CellState::done || state == CellState::unsettled; }
};

/// The border of the region where more than half of the runs make an EER, and its interval, in
/// (cm/s, deg).
struct EerBorders {
  std::vector<statistics::Isoline> half;  ///< P(EER) = 1/2
  std::vector<statistics::Isoline> ends;  ///< the border at either end of its interval
};

/// The impacts of one mass ratio and friction angle, over speed and angle.
struct PhaseDiagram {
  double q = 1;
  double phi_d_deg = 40;
  std::int64_t particles_per_target = 0;  ///< 0: differs from cell to cell
  /// Mutual escape speed at contact, for the upper axis; 0: no such axis.
  double v_esc_cm_per_s = 0;
  std::optional<double> threshold_cm_per_s;  ///< the curve v sin(theta) = threshold is drawn
  std::string threshold_source = "paper";    ///< whose it is, for the legend
  std::optional<EerBorders> borders = {};    ///< drawn in panels of P(EER)
  std::vector<PhaseCell> cells;              ///< in any order; at most one per (v, theta)
  std::string fidelity = {};                 ///< empty where the settings have no name
  std::int64_t settings = 0;                 ///< their number in the database; 0: not known
};

/// The quantities of maps: numbers of the largest remnant, the mass of the largest bound group over
/// that of both bodies, the most frequent class, the number of EERs among all remnants, and the
/// fraction of runs whose largest remnant is an EER.
enum class MapQuantity { b_over_a, c_over_a, m_lr, period, outcome, n_eer, p_largest_eer };

/// A map, or several as panels of one figure: one quantity for several diagrams, or several
/// quantities of one diagram. Panels share their axes, and their colours where they share the
/// quantity.
struct PhaseFigure {
  std::vector<PhaseDiagram> diagrams;
  std::vector<MapQuantity> quantities = {MapQuantity::b_over_a};
};
inline constexpr std::size_t most_panels = 24;

/// Draws the figure with gnuplot and installs it atomically. The extension names the format: .png,
/// .svg or .pdf. Throws InputError (no cells, two cells at one point, another extension, an unknown
/// class, several diagrams of several quantities, too many panels) and EnvironmentError (gnuplot is
/// missing, with the package to install; gnuplot or the disk fails).
void draw_phase_figure(const std::filesystem::path& path, const PhaseFigure& figure);

/// Draws b/a alone.
void draw_phase_diagram(const std::filesystem::path& path, const PhaseDiagram& diagram);

}  // namespace eerie::diagrams
