#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/base/bodies/sphere.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"
#include "tests/proof/ellipsoid.hpp"
#include "tests/proof/record.hpp"
#include "tests/proof/resting_body.hpp"

namespace eerie::proof {
namespace {

TEST(RestingSphere, KeepsItsShapeForADay) {
  Record record("validation", 30, "A resting cohesionless sphere",
                "A body of R = 50 m (1,000 particles, phi_d 40 deg), settled, then left alone for "
                "1e5 s: 150 dynamical times, 1e5 steps.");
  const Scene scene = parse_scene({{"numerics", {{"particles_per_target", 1000}}}});
  step::Solver solver(scene, initial::make_body(scene, particles::Body::target));
  const double escape = escape_speed({50, 2700});
  const Figure3 first = figure_of(scene, solver.state());
  Curve speed{"rms speed / escape speed", {}, {}};
  double fastest = 0, pressure = 0;
  for (int row = 1; row <= 100; ++row) {
    while (solver.state().time < 1000.0 * row) solver.cycle(1000.0 * row);
    double p = 0;
    for (const double one : solver.pressure()) p += one;
    const auto n = static_cast<double>(solver.state().size());
    speed.x.push_back(1000.0 * row);
    speed.y.push_back(rms_speed(solver.state()) / escape);
    fastest = std::max(fastest, speed.y.back());
    pressure += p / n / 100;
  }
  const Figure3 last = figure_of(scene, solver.state());
  record.within("largest rms speed / escape speed", fastest, 0, 1e-3,
                "bodies count as settled below 1e-3; nothing may feed them");
  record.within("change of b/a", std::abs(last.b_over_a - first.b_over_a), 0, 2e-3,
                "a hundredth of the scatter of b/a between seeds is 3e-4; creep must stay near it");
  record.within("change of a, relative", std::abs(last.a / first.a - 1), 0, 2e-3,
                "settling within the packing");
  record.within("mean pressure over (2/5) of the central one",
                pressure / (0.4 * central_pressure({50, 2700})), 0.95, 1.12,
                "virial theorem; the surface adds a part of order h/R = 0.19");
  record.figure({"rest",
                 "Speeds inside the sphere",
                 "time (s)",
                 "rms speed / escape speed",
                 {speed},
                 "set logscale y; set format y '10^{%T}'"});
}

}  // namespace
}  // namespace eerie::proof
