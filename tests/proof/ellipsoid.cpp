#include "tests/proof/ellipsoid.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/shapes/shape.hpp"
#include "solver/base/bodies/ellipsoid.hpp"
#include "solver/base/constants.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"

namespace eerie::proof {

StabilityLimit stability_limit(double a, double b, double c, double mu_d) {
  const auto [Ax, Ay, Az] = attraction_coefficients({a, b, c});
  const auto holds = [&](double W) {
    const double x = a * a * (W - Ax), y = b * b * (W - Ay), z = -c * c * Az;
    const double p = -(x + y + z) / 3;
    const double J2 = ((x - y) * (x - y) + (y - z) * (y - z) + (z - x) * (z - x)) / 6;
    return p > 0 && std::sqrt(J2) <= mu_d * p;
  };
  StabilityLimit limit;
  constexpr double step = 1e-5;
  for (double W = 0; W < 1; W += step) {
    if (!holds(W)) continue;
    if (!limit.stands) limit.slowest = W;
    limit.stands = true;
    limit.fastest = W;
  }
  return limit;
}

double lowest_standing(double mu_d) {
  // A body near to a sphere stands, a needle does not, and there is one limit between them.
  double falls = 0.001, stands = 1;
  while (stands - falls > 0.001) {
    const double ratio = (falls + stands) / 2;
    const StabilityLimit limit = stability_limit(1, ratio, ratio, mu_d);
    (limit.stands && limit.slowest == 0 ? stands : falls) = ratio;
  }
  return stands;
}

Figure3 figure_of(const Scene& scene, const particles::State& state) {
  const shapes::Shape shape = shapes::ellipsoid_of_inertia(state.x);
  const auto spin = shapes::angular_velocity(state.x, state.v);
  const double omega = spin ? norm(*spin) : 0;
  return {shape.b_over_a(), shape.c_over_a(), shape.a,
          omega * omega / (2 * pi * newton_G * scene.material.rho0_kg_per_m3)};
}

namespace {

Vec3 spin_of(const Scene& scene, double W) {
  return {0, 0, std::sqrt(W * 2 * pi * newton_G * scene.material.rho0_kg_per_m3)};
}

Scene with_friction(const Scene& scene, double phi_d_deg) {
  nlohmann::json json = to_json(scene);
  json["material"]["drucker_prager"]["phi_d_deg"] = phi_d_deg;
  return parse_scene(json);
}

}  // namespace

particles::State resting_ellipsoid(const Scene& scene, double ratio, double W) {
  particles::State state = initial::make_body(scene, particles::Body::target);
  const Vec3 omega = spin_of(scene, W);
  const double along = std::pow(ratio, -2.0 / 3), across = along * ratio;
  for (std::size_t i = 0; i < state.size(); ++i) {
    Vec3& x = state.x[i];
    x = {along * x.x, across * x.y, across * x.z};
    state.v[i] = cross(omega, x);
    state.S[i] = {};
  }
  // Friction of 75 degrees holds any of these shapes; motion relative to the spin is damped away.
  step::Solver solver(with_friction(scene, 75), state);
  const double crossing = scene.target.radius_m / solver.materials().target().longitudinal_speed();
  while (solver.state().time < 40 * crossing) {
    const double before = solver.state().time;
    solver.cycle(1e9);
    solver.damp(std::exp((before - solver.state().time) / (2 * crossing)), omega);
  }
  particles::State rested = solver.state();
  rested.time = 0, rested.step = 0;
  return rested;
}

SpinUp spun_up(const Scene& scene, particles::State state, double W_begin, double W_end,
               double seconds, double failure) {
  step::Solver solver(scene, std::move(state));
  const double a0 = figure_of(scene, solver.state()).a;
  const Vec3 torque = (spin_of(scene, W_end) - spin_of(scene, W_begin)) / seconds;
  SpinUp result;
  while (solver.state().time < seconds) {
    const double before = solver.state().time;
    solver.cycle(seconds);
    solver.spin_up((solver.state().time - before) * torque);
    result.last = figure_of(scene, solver.state());
    if (result.W_failed < 0 && result.last.a > (1 + failure) * a0) {
      result.W_failed = result.last.W;
      break;
    }
  }
  return result;
}

}  // namespace eerie::proof
