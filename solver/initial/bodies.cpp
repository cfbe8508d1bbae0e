#include "solver/initial/bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/base/mean.hpp"
#include "solver/base/sha256.hpp"
#include "solver/base/simd/pack.hpp"
#include "solver/base/version.hpp"
#include "solver/initial/orbit.hpp"
#include "solver/initial/packing.hpp"
#include "solver/initial/remnant_body.hpp"
#include "solver/scene/body_shape.hpp"
#include "solver/scene/tide.hpp"
#include "solver/scene/two_materials.hpp"
#include "solver/step/solver.hpp"

namespace eerie::initial {

namespace {

/// At rest: root-mean-square speed below this part of the escape speed.
constexpr double settled_fraction = 1e-3;
/// Damping time in sound crossings of the radius, and when to give up.
constexpr double damping_crossings = 1, patience_crossings = 400;

/// Of what does not turn with the body.
double rms_speed(const particles::State& s, const Vec3& omega) {
  double sum = 0;
  for (std::size_t i = 0; i < s.size(); ++i) sum += norm2(s.v[i] - cross(omega, s.x[i]));
  return std::sqrt(sum / static_cast<double>(s.size()));
}

double radius_of(const Scene& scene, particles::Body body) {
  return body == particles::Body::target ? scene.target.radius_m : impactor_radius(scene);
}

material::Material material_of(const Scene& scene, particles::Body body) {
  return material::make_material(body == particles::Body::target ? scene.material
                                                                 : impactor_material(scene));
}

Vec3 spin_of(const Scene& scene, particles::Body body) {
  return spin(body == particles::Body::target ? scene.target.spin : scene.impactor.spin);
}

BodyShape shape_of(const Scene& scene, particles::Body body) {
  return body == particles::Body::target ? target_shape(scene) : impactor_shape(scene);
}

/// Adds a rigid rotation about the origin. Without one not even the signs of zeros change.
void turn(particles::State& s, const Vec3& omega) {
  if (norm2(omega) == 0) return;
  for (std::size_t i = 0; i < s.size(); ++i) s.v[i] += cross(omega, s.x[i]);
}

using Stop = std::function<bool()>;

particles::State at_rest(const Scene& scene, particles::Body body, std::size_t n,
                         const Stop& stop) {
  const double radius = radius_of(scene, body);
  const material::Material material = material_of(scene, body);
  Random random(static_cast<std::uint64_t>(scene.numerics.seed), static_cast<std::uint64_t>(body));
  particles::State s;
  particles::resize(s, n);
  s.mass = particle_mass(scene);
  s.h = smoothing_length(scene);
  const BodyShape shape = shape_of(scene, body);
  s.x = packed_body(shape, scene.numerics.packing, n, radius, random, stop);
  const double p_centre = central_pressure({radius, material.reference_density});
  for (std::size_t i = 0; i < n; ++i) {
    s.id[i] = static_cast<std::uint32_t>(i);
    s.body[i] = static_cast<std::uint8_t>(body);
    const double p =
        p_centre * std::max(0.0, 1 - norm2(shape.on_sphere(s.x[i])) / (radius * radius));
    s.rho[i] = std::visit([p](const auto& eos) { return eos.density_at(p); }, material.eos);
  }
  turn(s, spin_of(scene, body));
  return s;
}

/// Root mean squares of the places along the axes of the body, which is about the origin.
Vec3 extent_of(const particles::State& s, const BodyShape& shape) {
  Vec3 sum;
  for (const Vec3& x : s.x)
    for (int k = 0; k < 3; ++k) {
      const double along = dot(shape.directions()[static_cast<std::size_t>(k)], x);
      sum[k] += along * along;
    }
  for (int k = 0; k < 3; ++k) sum[k] = std::sqrt(sum[k] / static_cast<double>(s.size()));
  return sum;
}

/// Throws NumericalError where an ellipsoid has flowed on its way to rest.
void require_kept(const particles::State& s, const BodyShape& shape, const char* name) {
  constexpr double most = 0.05;  // of a ratio of axes
  if (shape.is_sphere()) return;
  const Vec3 is = extent_of(s, shape), wanted = shape.semi_axes();
  if (std::abs(is.y / is.x - wanted.y / wanted.x) <= most &&
      std::abs(is.z / is.x - wanted.z / wanted.x) <= most)
    return;
  throw NumericalError(
      "flowing-body", 0, -1,
      fmt::format("the {} flows: at rest its b/a is {:.2f} and its c/a {:.2f}, for {:g} and {:g}; "
                  "give axes nearer to each other, more friction or more particles",
                  name, is.y / is.x, is.z / is.x, wanted.y / wanted.x, wanted.z / wanted.x));
}

/// The orders of memory differ from body to body; ids put them back.
particles::State sorted_by_id(particles::State s) {
  std::vector<std::uint32_t> place(s.size());
  for (std::uint32_t i = 0; i < s.size(); ++i) place[s.id[i]] = i;
  particles::visit_state(s, [&](const char*, auto& array) { particles::permute(array, place); });
  return s;
}

void append(particles::State& all, const particles::State& body, const Vec3& x, const Vec3& v) {
  const auto offset = static_cast<std::uint32_t>(all.size());
  for (std::size_t i = 0; i < body.size(); ++i) {
    all.id.push_back(offset + body.id[i]);
    all.body.push_back(body.body[i]);
    all.x.push_back(body.x[i] + x);
    all.v.push_back(body.v[i] + v);
    all.rho.push_back(body.rho[i]);
    all.S.push_back(body.S[i]);
  }
  for (auto field : {&particles::State::u, &particles::State::viscous_heat,
                     &particles::State::shear_work, &particles::State::damage_cbrt})
    (all.*field).insert((all.*field).end(), (body.*field).begin(), (body.*field).end());
}

/// Points of a packing with the density of equilibrium, before they settle.
particles::State unsettled_body(const Scene& scene, particles::Body body, const Stop& stop = {}) {
  if (is_remnant(scene, body)) return remnant_body(scene);
  const long n = body == particles::Body::target ? scene.numerics.particles_per_target
                                                 : impactor_particles(scene);
  return at_rest(scene, body, static_cast<std::size_t>(n), stop);
}

}  // namespace

const char* name_of(particles::Body body) {
  return body == particles::Body::target ? "target" : "impactor";
}

std::string body_hash(const Scene& scene, particles::Body body) {
  Scene only = scene;
  only.impact.v_imp_cm_per_s = only.impact.theta_imp_deg = only.impact.separation = 0;
  only.end = {};
  only.environment.primary = {};
  constexpr Scene::Spin at_rest{};
  constexpr Scene::Shape sphere{1, 1, 0};
  if (body == particles::Body::target) {
    only.impact.q = 1;
    // Its density sets the unit of smoothing lengths, and where it coheres nothing sees voids.
    only.impactor = {at_rest, sphere, only.impactor.material};
    only.impactor.material.phi_d_deg.reset();
  } else {
    only.target.spin = at_rest, only.target.shape = sphere, only.target.remnant = {};
  }
  return sha256_hex(
      fmt::format("{} {} {} {}", name_of(body), scene_hash(only), solver_version, vector_variant));
}

Settling::Settling(const Scene& scene, particles::Body body, const std::function<bool()>& stop)
    : Settling(scene, body,
               step::Solver(without_primary(scene), unsettled_body(scene, body, stop))) {}

Settling::Settling(const Scene& scene, particles::Body body, step::Solver begun)
    : scene_(scene),
      body_(body),
      radius_(radius_of(scene, body)),
      crossing_(radius_ / material_of(scene, body).longitudinal_speed()),
      omega_(spin_of(scene, body)),
      solver_(std::move(begun)) {}

bool Settling::is_at_rest() const {
  if (is_remnant(scene_, body_)) return true;  // in itself, that is; it may turn
  // At least a few damping times: at the very start nothing has moved yet.
  if (solver_.state().time < 10 * crossing_) return false;
  const double v_esc = escape_speed({radius_, material_of(scene_, body_).reference_density});
  return rms_speed(solver_.state(), omega_) <= settled_fraction * v_esc;
}

void Settling::cycle() {
  const double time = solver_.state().time;
  if (time > patience_crossings * crossing_)
    throw NumericalError(
        "unsettled-body", solver_.state().step, -1,
        fmt::format("the {} does not come to rest: after {:.0f} s its particles "
                    "still move at {:.2g} m/s; raise numerics.particles_per_target "
                    "or set numerics.h_over_spacing nearer to 1.2",
                    name_of(body_), time, rms_speed(solver_.state(), omega_)));
  solver_.cycle(time + 1e9);
  const double advanced = solver_.state().time - time;
  solver_.damp(std::exp(-advanced / (damping_crossings * crossing_)), omega_);
}

particles::State Settling::body() const {
  particles::State s = sorted_by_id(solver_.state());
  take_off_mean(s.x);
  if (is_remnant(scene_, body_)) {
    take_off_mean(s.v);
  } else {
    require_kept(s, shape_of(scene_, body_), name_of(body_));
    for (Vec3& v : s.v) v = {};
    turn(s, omega_);
  }
  for (auto* heat : {&s.u, &s.viscous_heat, &s.shear_work})
    std::fill(heat->begin(), heat->end(), 0.0);
  s.time = 0;
  s.step = 0;
  return s;
}

particles::State make_body(const Scene& scene, particles::Body body) {
  Settling settling(scene, body);
  while (!settling.is_at_rest()) settling.cycle();
  return settling.body();
}

namespace {

RelativeOrbit start_of(const Scene& scene) {
  const double contact = contact_distance(scene);
  const double mu = newton_G * target_mass(scene) * (1 + scene.impact.q);
  const RelativeOrbit at_contact = orbit_at_contact(contact, scene.impact.v_imp_cm_per_s / 100,
                                                    radians(scene.impact.theta_imp_deg));
  const double distance = contact * scene.impact.separation;
  if (!has_primary(scene)) return orbit_before_contact(at_contact, mu, distance);
  return orbit_before_contact(at_contact, mu, distance, Tide(scene.environment.primary),
                              scene.impact.q / (1 + scene.impact.q));
}

/// make(scene, body) makes each of the two, once the orbit is known to exist.
template <class Make>
particles::State made_on_orbit(const Scene& scene, Make&& make) {
  require_orbit(scene);
  return on_their_orbit(scene, make(scene, particles::Body::target),
                        make(scene, particles::Body::impactor));
}

}  // namespace

void require_orbit(const Scene& scene) { start_of(scene); }

particles::State on_their_orbit(const Scene& scene, const particles::State& target,
                                const particles::State& impactor) {
  const RelativeOrbit start = start_of(scene);
  // Shares of the masses that the particles really make up, so that momentum is zero.
  const double share =
      static_cast<double>(impactor.size()) / static_cast<double>(target.size() + impactor.size());
  particles::State all;
  all.mass = target.mass;
  all.h = target.h;
  append(all, target, -share * start.position, -share * start.velocity);
  append(all, impactor, (1 - share) * start.position, (1 - share) * start.velocity);
  return all;
}

particles::State make_impact(const Scene& scene) { return made_on_orbit(scene, make_body); }

particles::State make_unsettled_impact(const Scene& scene) {
  return made_on_orbit(
      scene, [](const Scene& s, particles::Body body) { return unsettled_body(s, body); });
}

}  // namespace eerie::initial
