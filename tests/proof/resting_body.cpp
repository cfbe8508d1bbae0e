#include "tests/proof/resting_body.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/base/bodies/sphere.hpp"
#include "solver/base/error.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"

namespace eerie::proof {

namespace {

/// The same body with the default time step and viscosity, which settle it.
Scene gentle(const Scene& scene) {
  nlohmann::json json = to_json(scene);
  const nlohmann::json defaults = to_json(parse_scene(nlohmann::json::object()));
  for (const char* name : {"cfl", "viscosity_alpha", "viscosity_beta", "gravity_interval",
                           "gravity_tolerance", "integrator"})
    json["numerics"][name] = defaults["numerics"][name];
  return parse_scene(json);
}

}  // namespace

double rms_speed(const particles::State& state) {
  const auto n = static_cast<double>(state.size());
  Vec3 mean;
  for (const Vec3& v : state.v) mean += v / n;
  double v2 = 0;
  for (const Vec3& v : state.v) v2 += norm2(v - mean);
  return std::sqrt(v2 / n);
}

RestQuality rest_quality(const Scene& scene, double seconds) {
  RestQuality q;
  const double radius = scene.target.radius_m, rho = scene.material.rho0_kg_per_m3;
  const double escape = escape_speed({radius, rho});
  try {
    step::Solver solver(scene, initial::make_body(gentle(scene), particles::Body::target));
    double cycles = 0;
    while (solver.state().time < seconds) {
      solver.cycle(seconds);
      if (solver.state().time < seconds / 5) continue;
      double p = 0;
      for (const double one : solver.pressure()) p += one;
      const auto n = static_cast<double>(solver.state().size());
      q.rms_speed = std::max(q.rms_speed, rms_speed(solver.state()) / escape);
      q.pressure += p / n / (0.4 * central_pressure({radius, rho}));
      ++cycles;
    }
    q.pressure /= std::max(1.0, cycles);
  } catch (const NumericalError& error) {
    q.failed = true;
    q.failure = error.kind;
  }
  return q;
}

}  // namespace eerie::proof
