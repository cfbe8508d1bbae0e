#include "tests/proof/roche.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/shapes/shape.hpp"
#include "solver/base/bodies/ellipsoid.hpp"
#include "solver/base/constants.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/scene/tide.hpp"
#include "solver/step/solver.hpp"
#include "tests/support/scenes.hpp"

namespace eerie::proof {

RocheEllipsoid roche_ellipsoid(double tide) {
  constexpr int rounds = 20000;
  double b = 1, c = 1;
  for (int k = 0; k < rounds; ++k) {
    const Vec3 A = attraction_coefficients({1, b, c});
    const double along = 2 * A.x - 3 * tide;
    if (along <= 0) return {};
    const double b_next = std::sqrt(along / (2 * A.y)),
                 c_next = std::sqrt(along / (2 * A.z + tide));
    const double change = std::abs(b_next - b) + std::abs(c_next - c);
    b = (b + b_next) / 2, c = (c + c_next) / 2;
    if (change < 1e-12) return {true, b, c};
  }
  return {};
}

LiquidInTide liquid_in_tide(double tide, int particles, double damped_s, double alone_s) {
  constexpr double distance = 1e6, rho = 2700;
  const double mass = tide * pi * rho * distance * distance * distance;
  const Scene scene = test::small_scene(
      {{"numerics", {{"particles_per_target", particles}}},
       {"material", {{"rheology", "fluid"}}},
       {"environment",
        {{"primary", {{"mass_kg", mass}, {"radius_m", 1e5}, {"distance_m", distance}}}}}});
  const Tide pull(scene.environment.primary);
  const Vec3 omega{0, 0, pull.rate()};
  particles::State state = initial::make_body(scene, particles::Body::target);
  for (std::size_t i = 0; i < state.size(); ++i) state.v[i] = cross(omega, state.x[i]);
  step::Solver solver(scene, std::move(state));
  const double damping_s = 1 / std::sqrt(newton_G * rho);
  while (solver.state().time < damped_s) {
    const double before = solver.state().time;
    solver.cycle(damped_s);
    solver.damp(std::exp((before - solver.state().time) / damping_s), omega);
  }
  while (solver.state().time < damped_s + alone_s) solver.cycle(damped_s + alone_s);
  const shapes::Shape shape = shapes::ellipsoid_of_inertia(solver.state().x);
  const Vec3 to = pull.place(solver.state().time);
  const double cosine = std::min(1.0, std::abs(dot(shape.axes[0], to)) / norm(to));
  return {shape.b_over_a(), shape.c_over_a(), shape.a / (2 * scene.target.radius_m),
          degrees(std::acos(cosine))};
}

}  // namespace eerie::proof
