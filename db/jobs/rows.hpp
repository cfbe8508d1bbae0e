#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::db {

enum class JobState { pending, running, done, failed, cancelled };
inline constexpr std::array<std::string_view, 5> job_state_names = {"pending", "running", "done",
                                                                    "failed", "cancelled"};

/// A job before it runs. Units are in the names.
struct NewJob {
  std::string hash;   ///< its identity, the SHA-256 of the canonical scene
  std::string scene;  ///< canonical JSON
  double q = 0, phi_d_deg = 0, v_imp_cm_per_s = 0, theta_imp_deg = 0;
  double v_over_v_esc = 0;
  std::int64_t particles_per_target = 0, seed = 0;
  double end_time_s = 0;
  double expected_particle_steps = 0;
  std::string fidelity = {};  ///< empty where its settings have no name
  int priority = 0;           ///< jobs of higher priority come first
};

/// The user's wish for a job, which may differ from its state.
enum class Wanted { run, pause, cancel };
inline constexpr std::array<std::string_view, 3> wanted_names = {"run", "pause", "cancel"};

/// A row of the table `jobs`, without its scene.
struct Job {
  std::int64_t id = 0;
  std::string hash;
  JobState state = JobState::pending;
  Wanted wanted = Wanted::run;
  int priority = 0;
  int crashes = 0;
  std::optional<double> wall_limit_s = {};
  double wall_s = 0;  ///< since a user last made it pending
  double q = 0, phi_d_deg = 0, v_imp_cm_per_s = 0, theta_imp_deg = 0;
  double expected_particle_steps = 0;
};

enum class ExitReason { finished, failed, stopped, crashed, lost };
inline constexpr std::array<std::string_view, 5> exit_reason_names = {"finished", "failed",
                                                                      "stopped", "crashed", "lost"};

/// The end of one attempt at a job. Unknown numbers stay empty.
struct AttemptEnd {
  ExitReason reason = ExitReason::lost;
  std::string failure_kind = {}, message = {};
  std::optional<double> core_seconds = {}, particle_steps = {};
  std::optional<std::int64_t> peak_memory_bytes = {};
  double wall_s = 0;      ///< wall time for which the worker was seen at work, s
  std::string host = {};  ///< its host; empty: that of the manager
  std::optional<std::int64_t> pid = {};
};

/// A row of the table `job_results`.
struct Result {
  std::string outcome_class = {};
  double m_lr_over_m_total = 0, m_slr_over_m_total = 0;
  std::optional<double> b_over_a = {}, c_over_a = {}, period_h = {};
  bool eer = false;
  int n_eer = 0, n_remnants = 0;
  bool settled = false;
  std::string unsettled_reason = {};
  std::optional<double> dL_over_L = {};
  std::int64_t steps = 0;
  double particle_steps = 0, wall_s = 0;
  int threads = 1;
  std::string solver_version = {}, host = {};
  std::optional<double> ended_at_s = {};  ///< simulated time
  std::string end_reason = {};            ///< empty where it is not known
};

/// Further numbers of a remnant (analysis/remnants/remnant_details.hpp), by the names of their
/// columns. result.json uses the same names.
inline constexpr std::array<const char*, 18> remnant_detail_columns = {
    "neck",
    "box_a_m",
    "box_b_m",
    "box_c_m",
    "box_b_over_a",
    "bulk_density_kg_per_m3",
    "spin_axis_x",
    "spin_axis_y",
    "spin_axis_z",
    "spin_tilt_deg",
    "origin_depth_mean_m",
    "origin_depth_p10_m",
    "origin_depth_p90_m",
    "orbit_pericentre_m",
    "orbit_eccentricity",
    "orbit_semi_major_axis_m",
    "orbit_period_h",
    "orbit_v_inf_m_per_s",
};

/// A row of the table `job_remnants`.
struct Remnant {
  int rank = 0;
  std::int64_t particles = 0;
  double mass_kg = 0, mass_over_total = 0;
  std::optional<double> a_m = {}, b_m = {}, c_m = {}, b_over_a = {}, c_over_a = {},
                        spin_period_h = {};
  bool eer = false;
  std::optional<double> target_fraction = {};
  std::optional<std::int64_t> bound_group = {};
  std::optional<double> bound_mass_over_total = {};
  std::optional<double> x_m = {}, y_m = {}, z_m = {}, vx_m_per_s = {}, vy_m_per_s = {},
                        vz_m_per_s = {};
  std::string shape_class = {};  ///< empty where it is not known
  std::array<std::optional<double>, remnant_detail_columns.size()> details = {};
};

}  // namespace eerie::db
