#pragma once

#include <concepts>
#include <filesystem>
#include <type_traits>
#include <vector>

#include "analysis/ending/steadiness.hpp"
#include "analysis/remnants/remnants.hpp"
#include "campaign/job_folder/row_log.hpp"

namespace eerie::job_folder {

/// One row of history.csv: the largest remnants at one moment of the run.
struct HistoryRow {
  double time_s = 0;
  int n_remnants = 0;
  double m_1_over_m_total = 0, m_2_over_m_total = 0;  ///< masses of the two largest remnants
  double b_over_a = 0, c_over_a = 0;                  ///< of the largest remnant
  // These are energies of the whole system, J. The last four are 0 without an energy equation.
  double kinetic_energy_J = 0, potential_energy_J = 0, internal_energy_J = 0, viscous_heat_J = 0,
         friction_heat_J = 0, shear_energy_J = 0;
  /// Relative change of the angular momentum since the start; 0 for a head-on impact.
  double dL_over_L = 0;
  // These say what carries the rubble and how correct its density is (solver/step/diagnosis.hpp).
  double eos_pressure_Pa = 0, viscous_pressure_Pa = 0, pressureless = 0;
  double density_kg_per_m3 = 0, summed_density_kg_per_m3 = 0, density_error = 0;
};

/// Visits the numbers of a row with their names, in the order of the columns. Reading and writing
/// both use this table.
template <class Row, class Visit>
requires std::same_as<std::remove_const_t<Row>, HistoryRow>
void visit_columns(Row& row, Visit&& visit) {
  visit("time_s", row.time_s);
  visit("n_remnants", row.n_remnants);
  visit("m_1_over_m_total", row.m_1_over_m_total);
  visit("m_2_over_m_total", row.m_2_over_m_total);
  visit("b_over_a", row.b_over_a);
  visit("c_over_a", row.c_over_a);
  visit("kinetic_energy_J", row.kinetic_energy_J);
  visit("potential_energy_J", row.potential_energy_J);
  visit("internal_energy_J", row.internal_energy_J);
  visit("viscous_heat_J", row.viscous_heat_J);
  visit("friction_heat_J", row.friction_heat_J);
  visit("shear_energy_J", row.shear_energy_J);
  visit("dL_over_L", row.dL_over_L);
  visit("eos_pressure_Pa", row.eos_pressure_Pa);
  visit("viscous_pressure_Pa", row.viscous_pressure_Pa);
  visit("pressureless", row.pressureless);
  visit("density_kg_per_m3", row.density_kg_per_m3);
  visit("summed_density_kg_per_m3", row.summed_density_kg_per_m3);
  visit("density_error", row.density_error);
}

/// Makes a row from the remnants of a moment, the most massive first.
HistoryRow history_row(double time_s, const std::vector<remnants::Remnant>& found);

/// Reads the rows of a history.csv; none where the file is missing. It leaves out incomplete lines.
std::vector<HistoryRow> read_history(const std::filesystem::path& path);

/// The shape of an impact over time.
using History = RowLog<HistoryRow>;

/// Whether two large bodies, each with at least half the impactor's mass, were apart after they had
/// been one. A merger of this kind is graze-and-merge.
bool separated_after_contact(const std::vector<HistoryRow>& rows, double q);

}  // namespace eerie::job_folder
