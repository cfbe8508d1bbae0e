#include "db/store/column_meanings.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace eerie::db {
namespace {

using enum ColumnKind;

constexpr ColumnMeaning table[] = {
    // the job
    {"state", "", word, "pending, running, done, failed or cancelled"},
    {"wanted", "", word, "what the user wants of the job: run, pause or cancel"},
    {"priority", "", integer, "jobs of higher priority come first"},
    {"crashes", "", integer, "since the job was last set to pending by hand"},
    // the impact
    {"job", "", integer, "number of the job in this database"},
    {"hash", "", word, "SHA-256 of the canonical scene: what the job is"},
    {"q", "", number, "impactor mass over target mass"},
    {"phi_d_deg", "deg", number, "friction angle"},
    {"v_imp_cm_per_s", "cm/s", number, "relative speed at contact"},
    {"theta_imp_deg", "deg", number, "relative velocity against line of centres at contact"},
    {"v_over_v_esc", "", number, "impact speed over mutual escape speed at contact"},
    {"particles_per_target", "", integer, "particles of the target"},
    {"seed", "", integer, "of all random numbers of the run"},
    {"end_time_s", "s", number, "simulated time at which the run ends at the latest"},
    {"fidelity", "", word, "name of the settings; empty: they have none"},
    {"scheme", "", word, "name of the numerical scheme (numerics.scheme)"},
    {"job_folder", "", word, "folder of its files, relative to the folder of the database"},
    // its outcome
    {"settings", "", integer, "what jobs share apart from impact, seed and output: job_settings"},
    {"class", "", word, "outcome class", View::results},
    {"m_lr_over_m_total", "", number, "mass of the largest bound group over all mass"},
    {"m_slr_over_m_total", "", number, "mass of the second largest bound group over all mass"},
    {"b_over_a", "", number, "intermediate over longest axis of the largest remnant",
     View::results},
    {"c_over_a", "", number, "shortest over longest axis of the largest remnant", View::results},
    {"period_h", "h", number, "spin period of the largest remnant; empty: does not spin",
     View::results},
    {"eer", "", flag, "whether the largest remnant is extremely elongated (b/a < 0.3)",
     View::results},
    {"n_eer", "", integer, "extremely elongated remnants", View::results},
    {"debris_fraction", "", number, "mass in clumps of fewer than 100 particles over all mass"},
    {"n_remnants", "", integer, "remnants of at least 100 particles"},
    {"settled", "", flag, "whether no remnants will meet again"},
    {"unsettled_reason", "", word, "which remnants will meet again"},
    // the run
    {"dL_over_L", "", number, "relative error of angular momentum"},
    {"steps", "", integer, "time steps"},
    {"particle_steps", "", number, "particles times steps"},
    {"wall_s", "s", number, "wall time of the last attempt"},
    {"threads", "", integer, "threads of the last attempt"},
    {"solver_version", "", word, "version of the solver that made the result"},
    {"host", "", word, "machine that made the result"},
    {"finished", "", word, "when the result was committed, UTC, ISO 8601"},
    {"stale", "", flag, "made by another solver version than the one in use", View::results},
    {"stale_reason", "", word, "the two solver versions of a stale result"},
    {"ended_at_s", "s", number, "simulated time at which the run ended"},
    {"end_reason", "", word, "settled, end-time or latest-time"},
    // remnants
    {"rank", "", integer, "1: the most massive remnant of its job"},
    {"particles", "", integer, "particles of the remnant"},
    {"mass_kg", "kg", number, "mass of the remnant"},
    {"mass_over_total", "", number, "mass of the remnant over all mass"},
    {"a_m", "m", number, "longest axis (full length) of the ellipsoid of inertia"},
    {"b_m", "m", number, "intermediate axis of the ellipsoid of inertia"},
    {"c_m", "m", number, "shortest axis of the ellipsoid of inertia"},
    {"b_over_a", "", number, "intermediate over longest axis", View::remnants},
    {"c_over_a", "", number, "shortest over longest axis", View::remnants},
    {"spin_period_h", "h", number, "spin period; empty: does not spin"},
    {"eer", "", flag, "whether the remnant is extremely elongated (b/a < 0.3)", View::remnants},
    {"target_fraction", "", number, "part of its particles that were the target's"},
    {"bound_group", "", integer, "number of the gravitationally bound group, 1: the most massive"},
    {"bound_mass_over_total", "", number, "mass of its bound group over all mass"},
    {"x_m", "m", number, "position of its centre of mass, x"},
    {"y_m", "m", number, "position of its centre of mass, y"},
    {"z_m", "m", number, "position of its centre of mass, z"},
    {"vx_m_per_s", "m/s", number, "velocity of its centre of mass, x"},
    {"vy_m_per_s", "m/s", number, "velocity of its centre of mass, y"},
    {"vz_m_per_s", "m/s", number, "velocity of its centre of mass, z"},
    {"impactor_fraction", "", number, "part of its particles that were the impactor's"},
    {"shape_class", "", word, "bilobed, elongated, flat or spherical"},
    {"neck", "", number, "least cross-section between two lobes over the thinner lobe's; 1: none"},
    {"box_a_m", "m", number, "longest edge of the box of least volume around it"},
    {"box_b_m", "m", number, "intermediate edge of that box"},
    {"box_c_m", "m", number, "shortest edge of that box"},
    {"box_b_over_a", "", number, "intermediate over longest edge of that box"},
    {"bulk_density_kg_per_m3", "kg/m^3", number, "mass over the volume of its ellipsoid"},
    {"spin_axis_x", "", number, "direction of its angular velocity, x"},
    {"spin_axis_y", "", number, "direction of its angular velocity, y"},
    {"spin_axis_z", "", number, "direction of its angular velocity, z"},
    {"spin_tilt_deg", "deg", number, "angle between spin and shortest axis"},
    {"origin_depth_mean_m", "m", number, "mean depth of its matter before the impact"},
    {"origin_depth_p10_m", "m", number, "depth above which a tenth of its matter lay"},
    {"origin_depth_p90_m", "m", number, "depth below which a tenth of its matter lay"},
    {"bound_to_largest", "", flag,
     "whether it is bound to the most massive remnant, as two points"},
    {"orbit_pericentre_m", "m", number,
     "least distance of its orbit from the most massive remnant"},
    {"orbit_eccentricity", "", number, "of that orbit; 1 and more: unbound"},
    {"orbit_semi_major_axis_m", "m", number, "of that orbit; empty: unbound"},
    {"orbit_period_h", "h", number, "of that orbit; empty: unbound"},
    {"orbit_v_inf_m_per_s", "m/s", number, "speed at infinity on that orbit; empty: bound"},
    // all jobs
    {"class", "", word, "outcome class; empty: no result", View::all_jobs},
    {"b_over_a", "", number, "intermediate over longest axis of the largest remnant",
     View::all_jobs},
    {"c_over_a", "", number, "shortest over longest axis of the largest remnant", View::all_jobs},
    {"period_h", "h", number, "spin period of the largest remnant", View::all_jobs},
    {"eer", "", flag, "whether the largest remnant is extremely elongated (b/a < 0.3)",
     View::all_jobs},
    {"n_eer", "", integer, "extremely elongated remnants", View::all_jobs},
    {"stale", "", flag, "made by another solver version than the one in use", View::all_jobs},
    // maps
    {"jobs", "", integer, "jobs of the point"},
    {"done", "", integer, "jobs of the point that have a result"},
    {"failed", "", integer, "jobs of the point that failed"},
    {"b_over_a", "", number, "mean b/a of the largest remnant", View::maps},
    {"b_over_a_min", "", number, "least b/a of the largest remnant"},
    {"b_over_a_max", "", number, "greatest b/a of the largest remnant"},
    {"c_over_a", "", number, "mean c/a of the largest remnant", View::maps},
    {"period_h", "h", number, "mean spin period of the largest remnant", View::maps},
    {"n_eer", "", number, "mean number of extremely elongated remnants", View::maps},
    {"p_eer", "", number, "fraction of results whose largest remnant is extremely elongated"},
    {"stale", "", number, "results of the point made by another solver version", View::maps},
    {"class", "", word, "most frequent outcome class", View::maps},
    {"class_share", "", number, "part of the results that have this class"},
    {"b_over_a_std", "", number, "standard deviation of b/a over the results"},
    {"c_over_a_std", "", number, "standard deviation of c/a over the results"},
    {"m_lr_over_m_total_std", "", number, "standard deviation of the largest group's mass"},
    {"period_std_h", "h", number, "standard deviation of the spin period"},
};

// Longer endings first: cm/s is not s, and not m/s.
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> endings = {{
    {"_kg_m2_per_s", "kg m^2/s"},
    {"_kg_per_m3", "kg/m^3"},
    {"_cm_per_s", "cm/s"},
    {"_km_per_s", "km/s"},
    {"_rad_per_s", "rad/s"},
    {"_m_per_s", "m/s"},
    {"_deg", "deg"},
    {"_kg", "kg"},
    {"_Pa", "Pa"},
    {"_m", "m"},
    {"_s", "s"},
    {"_h", "h"},
}};

}  // namespace

std::span<const ColumnMeaning> column_meanings() { return table; }

const ColumnMeaning* meaning_of(View view, std::string_view column) {
  const auto found = std::ranges::find_if(table, [&](const ColumnMeaning& entry) {
    return entry.name == column && (!entry.only || *entry.only == view);
  });
  return found == std::end(table) ? nullptr : &*found;
}

std::string_view unit_in_name(std::string_view column) {
  for (const auto& [ending, unit] : endings)
    if (column.ends_with(ending)) return unit;
  return "";
}

std::string_view unit_of(View view, std::string_view column) {
  const ColumnMeaning* known = meaning_of(view, column);
  return known != nullptr ? known->unit : unit_in_name(column);
}

ColumnKind kind_of(View view, const ViewColumn& column) {
  if (const ColumnMeaning* known = meaning_of(view, column.name)) return known->kind;
  if (column.declared == "TEXT") return word;
  return column.declared == "INTEGER" ? integer : number;
}

}  // namespace eerie::db
