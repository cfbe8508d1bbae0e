#include "solver/initial/bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/initial/orbit.hpp"
#include "solver/initial/packing.hpp"
#include "solver/step/solver.hpp"

namespace eerie {

namespace {

/// At rest: root-mean-square speed below this part of the escape speed.
constexpr double settled_fraction = 1e-3;
/// Damping time in sound crossings of the radius, and when to give up.
constexpr double damping_crossings = 1, patience_crossings = 400;

double rms_speed(const State& s) {
  double sum = 0;
  for (const Vec3& v : s.v) sum += norm2(v);
  return std::sqrt(sum / static_cast<double>(s.size()));
}

State at_rest(const Scene& scene, Body body, double radius, std::size_t n) {
  const Material material = make_material(scene);
  Random random(static_cast<std::uint64_t>(scene.numerics.seed), static_cast<std::uint64_t>(body));
  State s;
  resize(s, n);
  s.mass = particle_mass(scene);
  s.h = smoothing_length(scene);
  s.x = packed_sphere(scene.numerics.packing, n, radius, random);
  const double p_centre = central_pressure(scene.material.rho0_kg_per_m3, radius);
  for (std::size_t i = 0; i < n; ++i) {
    s.id[i] = static_cast<std::uint32_t>(i);
    s.body[i] = static_cast<std::uint8_t>(body);
    const double p = p_centre * std::max(0.0, 1 - norm2(s.x[i]) / (radius * radius));
    s.rho[i] = std::visit([p](const auto& eos) { return eos.density_at(p); }, material.eos);
  }
  return s;
}

/// The orders of memory differ from body to body; ids put them back.
State sorted_by_id(State s) {
  std::vector<std::uint32_t> place(s.size());
  for (std::uint32_t i = 0; i < s.size(); ++i) place[s.id[i]] = i;
  visit_state(s, [&](const char*, auto& array) { permute(array, place); });
  return s;
}

void append(State& all, const State& body, const Vec3& x, const Vec3& v) {
  const auto offset = static_cast<std::uint32_t>(all.size());
  for (std::size_t i = 0; i < body.size(); ++i) {
    all.id.push_back(offset + body.id[i]);
    all.body.push_back(body.body[i]);
    all.x.push_back(body.x[i] + x);
    all.v.push_back(v);
    all.rho.push_back(body.rho[i]);
    all.S.push_back(body.S[i]);
  }
  for (auto field : {&State::u, &State::viscous_heat, &State::shear_work, &State::damage_cbrt})
    (all.*field).insert((all.*field).end(), (body.*field).begin(), (body.*field).end());
}

}  // namespace

double central_pressure(double rho0, double radius) {
  return 2 * pi / 3 * newton_G * rho0 * rho0 * radius * radius;
}

double escape_speed(double rho0, double radius) {
  return radius * std::sqrt(8 * pi / 3 * newton_G * rho0);
}

namespace {

/// Points of a packing with the density of equilibrium, before they settle.
State unsettled_body(const Scene& scene, Body body) {
  const bool is_target = body == Body::target;
  return at_rest(scene, body, is_target ? scene.target.radius_m : impactor_radius(scene),
                 static_cast<std::size_t>(is_target ? scene.numerics.particles_per_target
                                                    : impactor_particles(scene)));
}

}  // namespace

State make_body(const Scene& scene, Body body) {
  const bool is_target = body == Body::target;
  const double radius = is_target ? scene.target.radius_m : impactor_radius(scene);
  Solver solver(scene, unsettled_body(scene, body));
  const double still = settled_fraction * escape_speed(scene.material.rho0_kg_per_m3, radius);
  const double crossing = radius / make_material(scene).longitudinal_speed();
  double time = 0;
  // At least a few damping times: at the very start nothing has moved yet.
  while (time < 10 * crossing || rms_speed(solver.state()) > still) {
    if (time > patience_crossings * crossing)
      throw NumericalError(
          "unsettled-body", solver.state().step, -1,
          fmt::format("the {} does not come to rest: after {:.0f} s its particles "
                      "still move at {:.2g} m/s; raise numerics.particles_per_target "
                      "or set numerics.h_over_spacing nearer to 1.2",
                      is_target ? "target" : "impactor", time, rms_speed(solver.state())));
    solver.cycle(solver.state().time + 1e9);
    const double advanced = solver.state().time - time;
    time = solver.state().time;
    solver.damp(std::exp(-advanced / (damping_crossings * crossing)));
  }
  State s = sorted_by_id(solver.state());
  Vec3 centre;
  for (const Vec3& x : s.x) centre += x;
  for (Vec3& x : s.x) x -= centre / static_cast<double>(s.size());
  for (Vec3& v : s.v) v = {};
  for (auto* heat : {&s.u, &s.viscous_heat, &s.shear_work})
    std::fill(heat->begin(), heat->end(), 0.0);
  s.time = 0;
  s.step = 0;
  return s;
}

namespace {

/// make(scene, body) makes each of the two, once the orbit is known to exist.
template <class Make>
State on_their_orbit(const Scene& scene, Make&& make) {
  const double contact = contact_distance(scene), q = scene.impact.q;
  const double mu = newton_G * target_mass(scene) * (1 + q);
  const RelativeOrbit start =
      orbit_before_contact(orbit_at_contact(contact, scene.impact.v_imp_cm_per_s / 100,
                                            radians(scene.impact.theta_imp_deg)),
                           mu, contact * scene.impact.separation);
  const State target = make(scene, Body::target), impactor = make(scene, Body::impactor);
  // Shares of the masses that the particles really make up, so that momentum is zero.
  const double share =
      static_cast<double>(impactor.size()) / static_cast<double>(target.size() + impactor.size());
  State all;
  all.mass = target.mass;
  all.h = target.h;
  append(all, target, -share * start.position, -share * start.velocity);
  append(all, impactor, (1 - share) * start.position, (1 - share) * start.velocity);
  return all;
}

}  // namespace

State make_impact(const Scene& scene) { return on_their_orbit(scene, make_body); }

State make_unsettled_impact(const Scene& scene) { return on_their_orbit(scene, unsettled_body); }

}  // namespace eerie
