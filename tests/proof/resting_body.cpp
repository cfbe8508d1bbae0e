#include "tests/proof/resting_body.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"

namespace eerie::proof {

namespace {

/// The same body with the default time step and viscosity, which settle it.
Scene gentle(const Scene& scene) {
  nlohmann::json json = to_json(scene);
  const nlohmann::json defaults = to_json(parse_scene(nlohmann::json::object()));
  for (const char* name :
       {"cfl", "viscosity_alpha", "viscosity_beta", "gravity_interval", "integrator"})
    json["numerics"][name] = defaults["numerics"][name];
  return parse_scene(json);
}

void measure_spacing(const State& s, RestQuality& q) {
  const double spacing = std::cbrt(s.mass / 2700), n = static_cast<double>(s.size());
  for (const Vec3& a : s.x) {
    double nearest2 = std::numeric_limits<double>::max();
    for (const Vec3& b : s.x)
      if (&a != &b) nearest2 = std::min(nearest2, norm2(a - b));
    const double distance = std::sqrt(nearest2) / spacing;
    q.nearest += distance / n;
    q.paired += (distance < 0.5) / n;
  }
}

}  // namespace

RestQuality rest_quality(const Scene& scene, double seconds) {
  RestQuality q;
  const double radius = scene.target.radius_m, rho = scene.material.rho0_kg_per_m3;
  const double escape = radius * std::sqrt(8 * pi / 3 * newton_G * rho);
  try {
    Solver solver(scene, make_body(gentle(scene), Body::target));
    double cycles = 0;
    while (solver.state().time < seconds) {
      solver.cycle(seconds);
      if (solver.state().time < seconds / 5) continue;
      double v2 = 0, p = 0;
      for (const Vec3& v : solver.state().v) v2 += norm2(v);
      for (const double one : solver.pressure()) p += one;
      const auto n = static_cast<double>(solver.state().size());
      q.rms_speed = std::max(q.rms_speed, std::sqrt(v2 / n) / escape);
      q.pressure += p / n / (0.4 * central_pressure(rho, radius));
      ++cycles;
    }
    q.pressure /= std::max(1.0, cycles);
    measure_spacing(solver.state(), q);
  } catch (const NumericalError& error) {
    q.failed = true;
    q.failure = error.kind;
  }
  return q;
}

}  // namespace eerie::proof
