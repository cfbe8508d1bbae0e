#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/remnants/outcome.hpp"
#include "analysis/remnants/remnant_details.hpp"
#include "analysis/remnants/remnants.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::remnants {

/// The analysis of one snapshot of an impact.
struct Analysis {
  OutcomeClass outcome = OutcomeClass::erosion;
  double m_lr_over_m_total = 0;   ///< mass of the largest bound group
  double m_slr_over_m_total = 0;  ///< mass of the second largest bound group
  bool settled = true;            ///< no two remnants will meet (again)
  std::string unsettled_reason;   ///< with the numbers; empty when settled
  /// Mass of clumps that are too small for a remnant and bound to one.
  double debris_bound_over_total = 0;
  std::vector<Remnant> remnants;  ///< the most massive first
  /// Of each remnant; empty where the caller does not ask for them.
  std::vector<RemnantDetails> details;
};

/// Finds remnants, bound groups, shapes, spins and the outcome class. The result does not depend on
/// the memory order of the particles. `separated_after_contact` says that the two bodies touched
/// and came apart again, which makes a merger graze-and-merge.
Analysis analyse(const io::Snapshot& snapshot, bool separated_after_contact = false);

/// Analyses the end of a run: adds the details of every remnant. `first` is the snapshot of the
/// start, which says where matter comes from, or null.
Analysis analyse_in_detail(const io::Snapshot& snapshot, const io::Snapshot* first,
                           bool separated_after_contact);

/// {"outcome": {"class", "m_lr_over_m_total", "m_slr_over_m_total", "settled",
///   "unsettled_reason" (string, empty when settled)},
///  "remnants": [{"rank" (from 1), "particles", "mass_kg", "mass_over_total", "a_m", "b_m", "c_m",
///   "b_over_a", "c_over_a", "spin_period_h" (null when it does not spin), "eer",
///   "target_fraction", "bound_group" (from 1), "bound_mass_over_total", "x_m", "y_m", "z_m",
///   "vx_m_per_s", "vy_m_per_s", "vz_m_per_s", and those of
///   RemnantDetails where they were asked for}]}
nlohmann::json to_json(const Analysis& analysis);

}  // namespace eerie::remnants
