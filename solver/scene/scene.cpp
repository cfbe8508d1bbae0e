#include "solver/scene/scene.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/base/sha256.hpp"
#include "solver/scene/body_shape.hpp"
#include "solver/scene/scene_schema_text.hpp"
#include "solver/scene/schemes.hpp"
#include "solver/scene/tide.hpp"
#include "solver/scene/two_materials.hpp"
#include "solver/scene/usable.hpp"
#include "solver/scene/validate.hpp"

namespace eerie {
using nlohmann::json;

void to_json(json& j, const Scene::Wall& wall) {
  j = {{"face", wall.face}, {"at_m", wall.at_m}, {"kind", wall.kind}};
}
void from_json(const json& j, Scene::Wall& wall) {
  j.at("face").get_to(wall.face);
  j.at("at_m").get_to(wall.at_m);
  j.at("kind").get_to(wall.kind);
}

namespace {

/// The one table of scene fields: JSON path <-> member. Reading and writing both walk it.
template <class SceneType, class Visit>
void visit_fields(SceneType& s, Visit&& visit) {
  visit("/target/radius_m", s.target.radius_m);
  visit("/target/spin/period_h", s.target.spin.period_h);
  visit("/target/spin/tilt_deg", s.target.spin.tilt_deg);
  visit("/target/spin/node_deg", s.target.spin.node_deg);
  visit("/target/shape/b_over_a", s.target.shape.b_over_a);
  visit("/target/shape/c_over_a", s.target.shape.c_over_a);
  visit("/target/shape/turn_deg", s.target.shape.turn_deg);
  visit("/target/remnant/file", s.target.remnant.file);
  visit("/target/remnant/sha256", s.target.remnant.sha256);
  visit("/impactor/spin/period_h", s.impactor.spin.period_h);
  visit("/impactor/spin/tilt_deg", s.impactor.spin.tilt_deg);
  visit("/impactor/spin/node_deg", s.impactor.spin.node_deg);
  visit("/impactor/shape/b_over_a", s.impactor.shape.b_over_a);
  visit("/impactor/shape/c_over_a", s.impactor.shape.c_over_a);
  visit("/impactor/shape/turn_deg", s.impactor.shape.turn_deg);
  visit("/impactor/material/rho0_kg_per_m3", s.impactor.material.rho0_kg_per_m3);
  visit("/impactor/material/phi_d_deg", s.impactor.material.phi_d_deg);
  visit("/impactor/material/cohesion_Pa", s.impactor.material.cohesion_Pa);
  visit("/impact/q", s.impact.q);
  visit("/impact/v_imp_cm_per_s", s.impact.v_imp_cm_per_s);
  visit("/impact/theta_imp_deg", s.impact.theta_imp_deg);
  visit("/impact/separation", s.impact.separation);
  visit("/material/rho0_kg_per_m3", s.material.rho0_kg_per_m3);
  visit("/material/shear_modulus_Pa", s.material.shear_modulus_Pa);
  visit("/material/eos", s.material.eos);
  visit("/material/tillotson/A_Pa", s.material.tillotson.A_Pa);
  visit("/material/tillotson/B_Pa", s.material.tillotson.B_Pa);
  visit("/material/tillotson/a", s.material.tillotson.a);
  visit("/material/tillotson/b", s.material.tillotson.b);
  visit("/material/tillotson/u0_J_per_kg", s.material.tillotson.u0_J_per_kg);
  visit("/material/tillotson/u_iv_J_per_kg", s.material.tillotson.u_iv_J_per_kg);
  visit("/material/tillotson/u_cv_J_per_kg", s.material.tillotson.u_cv_J_per_kg);
  visit("/material/tillotson/alpha", s.material.tillotson.alpha);
  visit("/material/tillotson/beta", s.material.tillotson.beta);
  visit("/material/linear/bulk_modulus_Pa", s.material.linear.bulk_modulus_Pa);
  visit("/material/ideal_gas/gamma", s.material.ideal_gas.gamma);
  visit("/material/energy", s.material.energy);
  visit("/material/rheology", s.material.rheology);
  visit("/material/drucker_prager/phi_d_deg", s.material.drucker_prager.phi_d_deg);
  visit("/material/drucker_prager/cohesion_Pa", s.material.drucker_prager.cohesion_Pa);
  visit("/material/drucker_prager/pressure", s.material.drucker_prager.pressure);
  visit("/material/lundborg/Y_0_Pa", s.material.lundborg.Y_0_Pa);
  visit("/material/lundborg/Y_M_Pa", s.material.lundborg.Y_M_Pa);
  visit("/material/lundborg/mu_i", s.material.lundborg.mu_i);
  visit("/material/lundborg/u_melt_J_per_kg", s.material.lundborg.u_melt_J_per_kg);
  visit("/material/fracture", s.material.fracture);
  visit("/material/grady_kipp/k_per_m3", s.material.grady_kipp.k_per_m3);
  visit("/material/grady_kipp/m", s.material.grady_kipp.m);
  visit("/material/grady_kipp/crack_speed", s.material.grady_kipp.crack_speed);
  visit("/environment/self_gravity", s.environment.self_gravity);
  visit("/environment/gravity_m_per_s2", s.environment.gravity_m_per_s2);
  visit("/environment/walls", s.environment.walls);
  visit("/environment/primary/mass_kg", s.environment.primary.mass_kg);
  visit("/environment/primary/radius_m", s.environment.primary.radius_m);
  visit("/environment/primary/distance_m", s.environment.primary.distance_m);
  visit("/environment/primary/azimuth_deg", s.environment.primary.azimuth_deg);
  visit("/environment/primary/retrograde", s.environment.primary.retrograde);
  visit("/numerics/scheme", s.numerics.scheme);
  visit("/numerics/particles_per_target", s.numerics.particles_per_target);
  visit("/numerics/seed", s.numerics.seed);
  visit("/numerics/packing", s.numerics.packing);
  visit("/numerics/kernel", s.numerics.kernel);
  visit("/numerics/h_over_spacing", s.numerics.h_over_spacing);
  visit("/numerics/smoothing", s.numerics.smoothing);
  visit("/numerics/gradient", s.numerics.gradient);
  visit("/numerics/artificial_stress", s.numerics.artificial_stress);
  visit("/numerics/integrator", s.numerics.integrator);
  visit("/numerics/viscosity", s.numerics.viscosity);
  visit("/numerics/viscosity_alpha", s.numerics.viscosity_alpha);
  visit("/numerics/viscosity_beta", s.numerics.viscosity_beta);
  visit("/numerics/viscosity_particles", s.numerics.viscosity_particles);
  visit("/numerics/void_density", s.numerics.void_density);
  visit("/numerics/voids", s.numerics.voids);
  visit("/numerics/cfl", s.numerics.cfl);
  visit("/numerics/opening_angle", s.numerics.opening_angle);
  visit("/numerics/gravity_tolerance", s.numerics.gravity_tolerance);
  visit("/numerics/gravity_interval", s.numerics.gravity_interval);
  visit("/numerics/list_skin", s.numerics.list_skin);
  visit("/numerics/late_sound_speed", s.numerics.late_sound_speed);
  visit("/numerics/flow_mach", s.numerics.flow_mach);
  visit("/numerics/viscous_stages", s.numerics.viscous_stages);
  visit("/numerics/rigid_flight", s.numerics.rigid_flight);
  visit("/numerics/precision", s.numerics.precision);
  visit("/end/time_s", s.end.time_s);
  visit("/end/latest_s", s.end.latest_s);
  visit("/end/settled/window_s", s.end.settled.window_s);
  visit("/end/settled/shape", s.end.settled.shape);
  visit("/end/settled/spin", s.end.settled.spin);
  visit("/end/settled/mass", s.end.settled.mass);
  visit("/end/settled/fall_back", s.end.settled.fall_back);
  visit("/end/settled/horizon_s", s.end.settled.horizon_s);
  visit("/output/snapshot_interval_s", s.output.snapshot_interval_s);
  visit("/output/history_interval_s", s.output.history_interval_s);
  visit("/output/checkpoint_interval_s", s.output.checkpoint_interval_s);
}

/// Fields that say nothing where they are absent.
template <class Member>
constexpr bool is_optional = std::is_same_v<Member, std::optional<double>>;

/// 5000.0 is an integer to JSON Schema but not to the parser's types: make it one.
void normalise_integers(json& node) {
  if (node.is_structured()) {
    for (json& child : node) normalise_integers(child);
  } else if (node.is_number_float()) {
    const double value = node.get<double>();
    if (value == std::floor(value) && std::abs(value) < 0x1p53)
      node = static_cast<std::int64_t>(value);
  }
}

}  // namespace

const json& scene_schema() {
  static const json schema = json::parse(scene_schema_text);
  return schema;
}

Scene parse_scene(const json& given, const std::string& where) {
  json document = given;
  normalise_integers(document);
  require_valid(scene_schema(), document, where);
  document = with_defaults(scene_schema(), with_scheme(std::move(document)));
  Scene scene;
  visit_fields(scene, [&](const char* path, auto& member) {
    const json::json_pointer pointer(path);
    if constexpr (is_optional<std::remove_reference_t<decltype(member)>>) {
      if (document.contains(pointer)) member = document.at(pointer);
    } else {
      document.at(pointer).get_to(member);
    }
  });
  require_usable(scene, where);
  return scene;
}

Scene changed(Scene scene, std::span<const FieldChange> changes, const std::string& where) {
  for (const FieldChange& change : changes)
    visit_fields(scene, [&](const char* path, auto& member) {
      using Member = std::remove_reference_t<decltype(member)>;
      if constexpr (is_optional<Member>) {
        if (change.pointer == path) member = change.value;
      } else if constexpr (std::is_arithmetic_v<Member> && !std::is_same_v<Member, bool>) {
        if (change.pointer == path) member = static_cast<Member>(change.value);
      }
    });
  require_usable(scene, where);
  return scene;
}

namespace {

/// Fields younger than the first results. Where one is off, or decides nothing, a scene is written
/// as it was before; but not where its scheme would turn the field on again.
void leave_out_younger_fields(json& numerics) {
  const json& of_scheme = numerics_of_scheme(numerics.at("scheme"));
  const auto leave_out = [&](const char* field, const json& off) {
    if (numerics.at(field) == off && of_scheme.value(field, off) == off) numerics.erase(field);
  };
  const bool has_voids = numerics.at("void_density") != 0;
  const bool softens = numerics.at("late_sound_speed") != 1;
  leave_out("void_density", 0.0);
  leave_out("voids", "all");
  leave_out("flow_mach", 0.0);
  leave_out("viscous_stages", 1);
  leave_out("rigid_flight", false);
  if (!has_voids) numerics.erase("voids");
  if (!softens) numerics.erase("flow_mach"), numerics.erase("viscous_stages");
}

/// A sphere has no axes; tilt and node are those of an ellipsoid, or of a spin.
void leave_out_of_body(json& body, const BodyShape& shape, const Scene::Spin& spin) {
  if (body.contains("remnant") && body["remnant"]["file"].get_ref<const std::string&>().empty())
    body.erase("remnant");
  if (!shape.is_sphere()) return;
  body.erase("shape");
  if (spin.period_h == 0) body.erase("spin");
}

}  // namespace

json to_json(const Scene& scene) {
  static const std::vector<json::json_pointer> pointers = [] {
    std::vector<json::json_pointer> all;
    const Scene any{};
    visit_fields(any, [&](const char* path, const auto&) { all.emplace_back(path); });
    return all;
  }();
  json document;
  std::size_t field = 0;
  visit_fields(scene, [&](const char*, const auto& member) {
    const json::json_pointer& pointer = pointers[field++];
    if constexpr (is_optional<std::remove_cvref_t<decltype(member)>>) {
      if (member) document[pointer] = *member;
    } else {
      document[pointer] = member;
    }
  });
  leave_out_younger_fields(document["numerics"]);
  leave_out_of_body(document["target"], target_shape(scene), scene.target.spin);
  leave_out_of_body(document["impactor"], impactor_shape(scene), scene.impactor.spin);
  leave_out_shared_material(document);
  if (document["impactor"].empty()) document.erase("impactor");
  if (!has_primary(scene)) document["environment"].erase("primary");
  return document;
}

std::string scene_hash(const Scene& scene) { return canonical_hash(to_json(scene)); }

std::string canonical_hash(json canonical) {
  canonical.erase("output");
  // The same body wherever its file lies.
  if (canonical["target"].contains("remnant")) canonical["target"]["remnant"].erase("file");
  // Younger than the first results: where they are off, a scene keeps the name it had before.
  if (canonical["numerics"]["late_sound_speed"] == 1)
    canonical["numerics"].erase("late_sound_speed");
  if (canonical["end"]["settled"]["window_s"] == 0) canonical["end"].erase("settled");
  return sha256_hex(canonical.dump());
}

double impactor_radius(const Scene& s) {
  const double rho = impactor_density(s);
  if (rho == s.material.rho0_kg_per_m3) return s.target.radius_m * std::cbrt(s.impact.q);
  return s.target.radius_m * std::cbrt(s.impact.q * s.material.rho0_kg_per_m3 / rho);
}
double target_mass(const Scene& s) {
  return s.material.rho0_kg_per_m3 * sphere_volume(s.target.radius_m);
}
double particle_mass(const Scene& s) {
  return target_mass(s) / static_cast<double>(s.numerics.particles_per_target);
}
double smoothing_length(const Scene& s) {
  return s.numerics.h_over_spacing * std::cbrt(particle_mass(s) / lowest_density(s));
}
double viscosity_length_ratio(const Scene& s) {
  if (s.numerics.viscosity_particles == 0) return 1;
  return std::cbrt(static_cast<double>(s.numerics.particles_per_target) /
                   static_cast<double>(s.numerics.viscosity_particles));
}
std::int64_t impactor_particles(const Scene& s) {
  return std::llround(s.impact.q * static_cast<double>(s.numerics.particles_per_target));
}
double contact_distance(const Scene& s) { return s.target.radius_m + impactor_radius(s); }
double softest_sound_speed(const Scene& s) {
  constexpr double most_bent = 0.01;
  const double stiffness = most_bent * s.material.shear_modulus_Pa;
  const double cohesion = std::max(s.material.drucker_prager.cohesion_Pa,
                                   impactor_material(s).drucker_prager.cohesion_Pa);
  const double held = std::sqrt(cohesion / stiffness);
  return std::min(1.0, std::max(s.numerics.late_sound_speed, held));
}
double bulk_sound_speed(const Scene& s) {
  const Scene::Material& m = s.material;
  const double K = m.eos == "tillotson" ? m.tillotson.A_Pa
                   : m.eos == "linear"  ? m.linear.bulk_modulus_Pa
                                        : 0;
  return std::sqrt(K / highest_density(s));
}
Vec3 spin(const Scene::Spin& s) {
  if (s.period_h == 0) return {};
  return spin_rate(s) * spin_axis(s);
}
double friction_coefficient(const Scene::Material& m) {
  return std::tan(radians(m.drucker_prager.phi_d_deg));
}

}  // namespace eerie
