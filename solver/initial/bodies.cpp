#include "solver/initial/bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/base/sphere.hpp"
#include "solver/initial/orbit.hpp"
#include "solver/initial/packing.hpp"
#include "solver/step/solver.hpp"

namespace eerie::initial {

namespace {

/// At rest: root-mean-square speed below this part of the escape speed.
constexpr double settled_fraction = 1e-3;
/// Damping time in sound crossings of the radius, and when to give up.
constexpr double damping_crossings = 1, patience_crossings = 400;

double rms_speed(const particles::State& s) {
  double sum = 0;
  for (const Vec3& v : s.v) sum += norm2(v);
  return std::sqrt(sum / static_cast<double>(s.size()));
}

particles::State at_rest(const Scene& scene, particles::Body body, double radius, std::size_t n) {
  const material::Material material = material::make_material(scene);
  Random random(static_cast<std::uint64_t>(scene.numerics.seed), static_cast<std::uint64_t>(body));
  particles::State s;
  particles::resize(s, n);
  s.mass = particle_mass(scene);
  s.h = smoothing_length(scene);
  s.x = packed_sphere(scene.numerics.packing, n, radius, random);
  const double p_centre = central_pressure({radius, scene.material.rho0_kg_per_m3});
  for (std::size_t i = 0; i < n; ++i) {
    s.id[i] = static_cast<std::uint32_t>(i);
    s.body[i] = static_cast<std::uint8_t>(body);
    const double p = p_centre * std::max(0.0, 1 - norm2(s.x[i]) / (radius * radius));
    s.rho[i] = std::visit([p](const auto& eos) { return eos.density_at(p); }, material.eos);
  }
  return s;
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
    all.v.push_back(v);
    all.rho.push_back(body.rho[i]);
    all.S.push_back(body.S[i]);
  }
  for (auto field : {&particles::State::u, &particles::State::viscous_heat,
                     &particles::State::shear_work, &particles::State::damage_cbrt})
    (all.*field).insert((all.*field).end(), (body.*field).begin(), (body.*field).end());
}

/// Points of a packing with the density of equilibrium, before they settle.
particles::State unsettled_body(const Scene& scene, particles::Body body) {
  const bool is_target = body == particles::Body::target;
  return at_rest(scene, body, is_target ? scene.target.radius_m : impactor_radius(scene),
                 static_cast<std::size_t>(is_target ? scene.numerics.particles_per_target
                                                    : impactor_particles(scene)));
}

}  // namespace

particles::State make_body(const Scene& scene, particles::Body body) {
  const bool is_target = body == particles::Body::target;
  const double radius = is_target ? scene.target.radius_m : impactor_radius(scene);
  step::Solver solver(scene, unsettled_body(scene, body));
  const double still = settled_fraction * escape_speed({radius, scene.material.rho0_kg_per_m3});
  const double crossing = radius / material::make_material(scene).longitudinal_speed();
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
  particles::State s = sorted_by_id(solver.state());
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
particles::State on_their_orbit(const Scene& scene, Make&& make) {
  const double contact = contact_distance(scene), q = scene.impact.q;
  const double mu = newton_G * target_mass(scene) * (1 + q);
  const RelativeOrbit start =
      orbit_before_contact(orbit_at_contact(contact, scene.impact.v_imp_cm_per_s / 100,
                                            radians(scene.impact.theta_imp_deg)),
                           mu, contact * scene.impact.separation);
  const particles::State target = make(scene, particles::Body::target),
                         impactor = make(scene, particles::Body::impactor);
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

}  // namespace

particles::State make_impact(const Scene& scene) { return on_their_orbit(scene, make_body); }

particles::State make_unsettled_impact(const Scene& scene) {
  return on_their_orbit(scene, unsettled_body);
}

}  // namespace eerie::initial
