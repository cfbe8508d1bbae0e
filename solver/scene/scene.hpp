#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace eerie {

/// Everything that decides the result of one impact, and nothing that a machine decides.
/// Names carry their unit; defaults, ranges and meanings stand in scene.schema.json, which
/// parse_scene() applies. An instance holds validated values only.
struct Scene {
  struct Target {
    double radius_m;
  } target;

  struct Impact {
    double q;               ///< impactor mass over target mass, 0 < q <= 1
    double v_imp_cm_per_s;  ///< relative speed at contact
    double theta_imp_deg;   ///< relative velocity against line of centres at contact; 0: head-on
    double separation;      ///< distance of centres at the start, in units of R_t + R_i
  } impact;

  struct Tillotson {
    double A_Pa, B_Pa, a, b, u0_J_per_kg, u_iv_J_per_kg, u_cv_J_per_kg, alpha, beta;
  };
  struct DruckerPrager {
    double phi_d_deg;    ///< friction angle; mu_d = tan(phi_d)
    double cohesion_Pa;  ///< yield strength at zero pressure
  };
  struct Material {
    double rho0_kg_per_m3;
    double shear_modulus_Pa;
    std::string eos;  ///< "tillotson"
    Tillotson tillotson;
    std::string rheology;  ///< "drucker-prager" or "fluid"
    DruckerPrager drucker_prager;
  } material;

  struct Numerics {
    std::int64_t particles_per_target;
    std::int64_t seed;      ///< decides every random number of the run
    std::string packing;    ///< "glass" or "lattice" (randomly oriented)
    std::string kernel;     ///< "cubic-spline", ...
    double h_over_spacing;  ///< smoothing length over (m/rho0)^(1/3), constant in time
    double viscosity_alpha, viscosity_beta;
    double cfl;                     ///< dt = cfl h / (c_l + h |div v|), c_l: longitudinal wave
    double opening_angle;           ///< Barnes-Hut: node size over distance
    std::int64_t gravity_interval;  ///< steps from one gravity kick to the next
    double list_skin;               ///< extra neighbour search radius over 2h
    std::string precision;          ///< of pair sums: "float" or "double"; the state is double
  } numerics;

  struct End {
    double time_s;
  } end;

  struct Output {
    double snapshot_interval_s;    ///< simulated time between snapshots; 0: only the last
    double history_interval_s;     ///< simulated time between rows of history.csv
    double checkpoint_interval_s;  ///< wall time between checkpoints
  } output;
};

/// Checks `json` against the schema, fills defaults and converts. Throws InputError naming the
/// path (prefixed with `where`), the value, the allowed range and the mend.
Scene parse_scene(const nlohmann::json& json, const std::string& where = "scene");

/// The scene with every field written out, in sorted order and with canonical numbers
/// (30 and 30.0 are one). parse_scene() of it gives the same scene.
nlohmann::json to_json(const Scene& scene);

/// SHA-256 (hex) of the canonical scene without its output section: what a job *is*.
std::string scene_hash(const Scene& scene);

/// The JSON Schema of a scene, as shipped.
const nlohmann::json& scene_schema();

/// Derived numbers used all over, SI.
double impactor_radius(const Scene& scene);
double target_mass(const Scene& scene);
double particle_mass(const Scene& scene);
double smoothing_length(const Scene& scene);
std::int64_t impactor_particles(const Scene& scene);
double contact_distance(const Scene& scene);
double friction_coefficient(const Scene& scene);

}  // namespace eerie
