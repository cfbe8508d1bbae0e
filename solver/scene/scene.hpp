#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

namespace eerie {

/// Remnants are looked at so often in end.settled.window_s.
inline constexpr int looks_per_window = 8;

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
    double phi_d_deg;      ///< friction angle; mu_d = tan(phi_d)
    double cohesion_Pa;    ///< yield strength at zero pressure
    std::string pressure;  ///< that friction feels: "eos", or "total" with that of viscosity
  };
  struct Linear {
    double bulk_modulus_Pa;
  };
  struct IdealGas {
    double gamma;
  };
  struct Lundborg {
    double Y_0_Pa, Y_M_Pa;   ///< strength at zero and at infinite pressure
    double mu_i;             ///< friction of intact rock
    double u_melt_J_per_kg;  ///< where strength ends
  };
  struct GradyKipp {
    double k_per_m3, m;  ///< Weibull's distribution of flaws, n(eps) = k eps^m
    double crack_speed;  ///< of the longitudinal wave
  };
  struct Material {
    double rho0_kg_per_m3;
    double shear_modulus_Pa;
    std::string eos;  ///< "tillotson", "linear" or "ideal-gas"
    Tillotson tillotson;
    Linear linear;
    IdealGas ideal_gas;
    std::string energy;    ///< "none" (u = 0) or "integrated"
    std::string rheology;  ///< "drucker-prager", "fluid", "elastic" or "lundborg"
    DruckerPrager drucker_prager;
    Lundborg lundborg;
    std::string fracture;  ///< "none" or "grady-kipp"
    GradyKipp grady_kipp;
  } material;

  /// A plane that particles do not cross; what is beyond it is their mirror image.
  struct Wall {
    std::string face;  ///< "x_low", "x_high", "y_low", ...: the side of the scene it closes
    double at_m;       ///< where it stands on its axis
    std::string kind;  ///< "slip" (no friction) or "rough" (sticks; friction is the material's)
    bool operator==(const Wall&) const = default;
  };
  struct Environment {
    bool self_gravity;
    std::array<double, 3> gravity_m_per_s2;  ///< uniform, added to self-gravity
    std::vector<Wall> walls;                 ///< at most one for each face
  } environment;

  struct Numerics {
    std::string scheme;  ///< the set of defaults that the others took theirs from
    std::int64_t particles_per_target;
    std::int64_t seed;         ///< decides every random number of the run
    std::string packing;       ///< "glass" or "lattice" (randomly oriented)
    std::string kernel;        ///< "cubic-spline", ...
    double h_over_spacing;     ///< smoothing length over (m/rho0)^(1/3), constant in time
    std::string smoothing;     ///< "constant" h or "evolving", h ~ rho^(-1/3)
    std::string gradient;      ///< "corrected-fully", "corrected", "corrected-rate" or "plain"
    double artificial_stress;  ///< of Gray, Monaghan & Swift (2001); 0: off
    std::string integrator;    ///< "leapfrog", "leapfrog-pece" or "staggered"
    std::string viscosity;     ///< "monaghan" or "shear-free"
    double viscosity_alpha, viscosity_beta;
    std::int64_t viscosity_particles;  ///< per target, whose h viscosity has; 0: its own
    double void_density;   ///< of rho0: where particles lie less densely, nothing presses; 0: off
    std::string voids;     ///< which of them: "all", or "gaps" between two surfaces alone
    double cfl;            ///< dt = cfl h / (c_l + h |div v|), c_l: longitudinal wave
    double opening_angle;  ///< Barnes-Hut: node size over distance
    double gravity_tolerance;       ///< relative error of gravity between its evaluations
    std::int64_t gravity_interval;  ///< the most steps from one evaluation to the next
    double list_skin;               ///< extra neighbour search radius over 2h
    double late_sound_speed;        ///< times sound speeds once nothing moves fast; 1: never
    double flow_mach;               ///< up to which sound speeds fall before that; 0: not at all
    bool rigid_flight;              ///< clumps that do not change fly as rigid bodies
    std::string precision;          ///< of pair sums: "float" or "double"; the state is double
  } numerics;

  /// When remnants count as settled (analysis/ending/steadiness.hpp).
  struct Settled {
    double window_s;   ///< over which nothing changes; 0: a run does not end by this
    double shape;      ///< most change of b/a and of c/a
    double spin;       ///< most relative change of the spin rate
    double mass;       ///< of all: lighter clumps are fragments
    double fall_back;  ///< part of all the mass: so much may change, and fall back later
    double horizon_s;  ///< contacts that orbits foretell for later do not count
  };
  struct End {
    double time_s;
    double latest_s;  ///< until then a run goes on while remnants are going to meet; 0: never
    Settled settled;  ///< ends a run before time_s
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
/// (30 and 30.0 are one); numerics.void_density, voids and rigid_flight only where they are on.
/// parse_scene() of it gives the same scene.
nlohmann::json to_json(const Scene& scene);

/// A numeric field by its JSON pointer ("/impact/q"), and a value that the schema allows.
struct FieldChange {
  std::string pointer;
  double value = 0;
};
/// The scene with other values in some fields. Throws InputError where they do not fit together,
/// as parse_scene() does.
Scene changed(Scene scene, std::span<const FieldChange> changes, const std::string& where);

/// SHA-256 (hex) of the canonical scene without its output section: what a job *is*.
std::string scene_hash(const Scene& scene);
/// scene_hash() of a scene whose to_json() is at hand.
std::string canonical_hash(nlohmann::json canonical);

/// The JSON Schema of a scene, as shipped.
const nlohmann::json& scene_schema();

/// Derived numbers used all over, SI.
double impactor_radius(const Scene& scene);
double target_mass(const Scene& scene);
double particle_mass(const Scene& scene);
double smoothing_length(const Scene& scene);
/// h of viscosity over h: below 1 where numerics.viscosity_particles asks for that of more
/// particles.
double viscosity_length_ratio(const Scene& scene);
std::int64_t impactor_particles(const Scene& scene);
double contact_distance(const Scene& scene);
double friction_coefficient(const Scene& scene);
double bulk_sound_speed(const Scene& scene);  ///< sqrt(K/rho0) of the cold material; 0 for a gas
/// Whether particles carry an internal energy, and a damage that grows.
inline bool has_energy(const Scene& scene) { return scene.material.energy == "integrated"; }
inline bool has_fracture(const Scene& scene) { return scene.material.fracture != "none"; }
/// Whether viscosity leaves shear alone, and whether friction feels what viscosity carries.
inline bool is_shear_free(const Scene& scene) { return scene.numerics.viscosity == "shear-free"; }
inline bool feels_viscosity(const Scene& scene) {
  return scene.material.drucker_prager.pressure == "total";
}

}  // namespace eerie
