#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/base/vec3.hpp"

namespace eerie {

/// A run examines its remnants this many times per end.settled.window_s.
inline constexpr int looks_per_window = 8;

/// Everything that decides the result of one impact, and nothing that depends on the machine. Names
/// carry their unit. scene.schema.json holds defaults, ranges and meanings; parse_scene() applies
/// it. An instance holds validated values only.
struct Scene {
  /// The rotation of a body before the impact.
  struct Spin {
    double period_h;  ///< 0: it does not turn
    double tilt_deg;  ///< between its axis and that of the orbit; 0: prograde, 180: retrograde
    double node_deg;  ///< azimuth of its axis about that of the orbit, from the x-axis
  };

  /// The shape of a body before the impact: an ellipsoid whose shortest axis is that of its spin.
  struct Shape {
    double b_over_a, c_over_a;  ///< 1: a sphere
    double turn_deg;  ///< of the longest axis about the shortest; 0: where that one is tilted to
  };

  /// A body that another impact left, in a file that `eerie remnant` wrote.
  struct Remnant {
    std::string file;    ///< empty: the body is made
    std::string sha256;  ///< of the file; identifies the body wherever the file lies
  };

  struct Target {
    double radius_m;  ///< of the sphere of its volume
    Spin spin;
    Shape shape;
    Remnant remnant;
  } target{};

  struct Impactor {
    Spin spin;
    Shape shape;
    /// What its matter has of its own; where a value is absent, that of the target
    /// (two_materials.hpp).
    struct Material {
      std::optional<double> rho0_kg_per_m3, phi_d_deg, cohesion_Pa;
    } material;
  } impactor{};

  struct Impact {
    double q;               ///< impactor mass over target mass, 0 < q <= 1
    double v_imp_cm_per_s;  ///< relative speed at contact
    double theta_imp_deg;  ///< between relative velocity and line of centres at contact; 0: head-on
    double separation;     ///< distance of centres at the start, in units of R_t + R_i
  } impact{};

  struct Tillotson {
    double A_Pa, B_Pa, a, b, u0_J_per_kg, u_iv_J_per_kg, u_cv_J_per_kg, alpha, beta;
  };
  struct DruckerPrager {
    double phi_d_deg;    ///< friction angle; mu_d = tan(phi_d)
    double cohesion_Pa;  ///< yield strength at zero pressure
    /// The pressure that friction uses: "eos", or "total", which adds that of viscosity.
    std::string pressure;
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
    double u_melt_J_per_kg;  ///< melting energy, at which strength vanishes
  };
  struct GradyKipp {
    double k_per_m3, m;  ///< Weibull's distribution of flaws: n(eps) = k eps^m
    double crack_speed;  ///< in units of the longitudinal wave's speed
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
  } material{};

  /// A plane that particles do not cross. Behind it lies their mirror image.
  struct Wall {
    std::string face;  ///< the side of the scene that it closes: "x_low", "x_high", "y_low", ...
    double at_m;       ///< its position on its axis
    /// "slip" (no friction) or "rough" (material sticks and shears by its own friction).
    std::string kind;
    bool operator==(const Wall&) const = default;
  };
  /// A heavy body about which both bodies go on a circle (tide.hpp).
  struct Primary {
    double mass_kg;      ///< 0: there is none
    double radius_m;     ///< of a homogeneous ball
    double distance_m;   ///< of its centre from that of the bodies
    double azimuth_deg;  ///< towards it as the run starts, from +x in the plane of the impact
    bool retrograde;     ///< whether the bodies go about it against the sense of the impact
  };
  struct Environment {
    bool self_gravity;
    std::array<double, 3> gravity_m_per_s2;  ///< a uniform field, added to self-gravity
    std::vector<Wall> walls;                 ///< at most one for each face
    Primary primary;
  } environment{};

  struct Numerics {
    std::string scheme;  ///< the named set of defaults for the fields below
    std::int64_t particles_per_target;
    std::int64_t seed;         ///< the seed of every random number of the run
    std::string packing;       ///< "glass" or "lattice" (randomly oriented)
    std::string kernel;        ///< "cubic-spline", ...
    double h_over_spacing;     ///< smoothing length in units of (m/rho0)^(1/3), constant in time
    std::string smoothing;     ///< h is "constant" or "evolving" as rho^(-1/3)
    std::string gradient;      ///< "corrected-fully", "corrected", "corrected-rate" or "plain"
    double artificial_stress;  ///< its strength (Gray, Monaghan & Swift 2001); 0: off
    std::string integrator;    ///< "leapfrog", "leapfrog-pece" or "staggered"
    std::string viscosity;     ///< "monaghan" or "shear-free"
    double viscosity_alpha, viscosity_beta;
    /// Viscosity takes the h of so many particles per target; 0: of its own.
    std::int64_t viscosity_particles;
    /// In units of rho0; particles that lie less densely have no pressure; 0: off.
    double void_density;
    std::string voids;  ///< "all" such places, or only "gaps" between two surfaces
    double cfl;         ///< dt = cfl h / (c_l + h |div v|), c_l the speed of the longitudinal wave
    double opening_angle;           ///< of the Barnes-Hut walk: node size over distance
    double gravity_tolerance;       ///< relative error of gravity between its evaluations
    std::int64_t gravity_interval;  ///< the most steps from one evaluation to the next
    double list_skin;               ///< extra neighbour search radius over 2h
    double late_sound_speed;        ///< factor on sound speeds in the late phase; 1: there is none
    double flow_mach;               ///< greatest Mach number of earlier softening; 0: there is none
    std::int64_t viscous_stages;    ///< most stages in which viscosity damps, where it lags
    bool rigid_flight;              ///< whether clumps that do not change fly as rigid bodies
    std::string precision;  ///< of the pair sums: "float" or "double"; the state is always double
  } numerics{};

  /// When remnants count as settled (analysis/ending/steadiness.hpp).
  struct Settled {
    double window_s;  ///< the time over which nothing may change; 0: settling ends no run
    double shape;     ///< the largest change of b/a and of c/a
    double spin;      ///< the largest relative change of the spin rate
    double mass;      ///< in units of all mass; lighter clumps are fragments
    /// In units of all mass; so much may change, and so much may fall back later.
    double fall_back;
    double horizon_s;  ///< contacts that orbits predict for a later time do not count
  };
  struct End {
    double time_s;
    /// A run goes on until then while remnants are going to meet; 0: it does not wait.
    double latest_s;
    Settled settled;  ///< what may end a run before time_s
  } end{};

  struct Output {
    double snapshot_interval_s;    ///< simulated time between snapshots; 0: only the last
    double history_interval_s;     ///< simulated time between rows of history.csv
    double checkpoint_interval_s;  ///< wall time between checkpoints
  } output{};
};

/// An impactor of too few particles: more particles, that is, a finer fidelity, help.
struct TooFewParticles : InputError {
  using InputError::InputError;
};

/// Checks `json` against the schema, fills in defaults and converts. Throws InputError, which names
/// the path (after `where`), the value, the allowed range and the mend.
Scene parse_scene(const nlohmann::json& json, const std::string& where = "scene");

/// The scene with every field, in sorted order and with canonical numbers (30 and 30.0 are equal).
/// numerics.void_density, voids and rigid_flight appear only where they are on, spin and shape
/// where a body turns or is no sphere, impactor.material where it is another. parse_scene() turns
/// it back into the same scene.
nlohmann::json to_json(const Scene& scene);

/// A numeric field, named by its JSON pointer ("/impact/q"), and a value that the schema allows.
struct FieldChange {
  std::string pointer;
  double value = 0;
};
/// The scene with other values in some fields. Throws InputError, as parse_scene() does, where the
/// values do not fit together.
Scene changed(Scene scene, std::span<const FieldChange> changes, const std::string& where);

/// The SHA-256 (hexadecimal) of the canonical scene without its output section. It identifies a
/// job.
std::string scene_hash(const Scene& scene);
/// scene_hash() of a scene whose to_json() the caller already has.
std::string canonical_hash(nlohmann::json canonical);

/// The JSON Schema of a scene, as the program contains it.
const nlohmann::json& scene_schema();

/// Numbers that follow from a scene and that many rooms use, in SI.
double impactor_radius(const Scene& scene);
double target_mass(const Scene& scene);
double particle_mass(const Scene& scene);
double smoothing_length(const Scene& scene);  ///< of the less dense of two materials
/// The smoothing length of viscosity in units of h. It is below 1 where
/// numerics.viscosity_particles asks for that of more particles.
double viscosity_length_ratio(const Scene& scene);
std::int64_t impactor_particles(const Scene& scene);
double contact_distance(const Scene& scene);
double friction_coefficient(const Scene::Material& material);
/// The angular velocity of a body before the impact, rad/s. The orbit turns about the z-axis.
Vec3 spin(const Scene::Spin& spin);
/// The factor on sound speeds of the late phase: numerics.late_sound_speed, but no lower than where
/// cohesive matter bends by a percent before it yields; 1 where nothing may be softer.
double softest_sound_speed(const Scene& scene);
/// sqrt(K/rho0) of the cold material, the denser one of two; 0 for a gas.
double bulk_sound_speed(const Scene& scene);
/// Whether particles carry an internal energy; whether they carry a damage that grows.
inline bool has_energy(const Scene& scene) { return scene.material.energy == "integrated"; }
inline bool has_fracture(const Scene& scene) { return scene.material.fracture != "none"; }
/// Whether viscosity ignores shear; whether friction adds the pressure of viscosity.
inline bool is_shear_free(const Scene& scene) { return scene.numerics.viscosity == "shear-free"; }
inline bool feels_viscosity(const Scene& scene) {
  return scene.material.drucker_prager.pressure == "total";
}

}  // namespace eerie
