#include <gtest/gtest.h>

#include <cmath>

#include "solver/initial/bodies.hpp"
#include "solver/initial/packing.hpp"
#include "solver/step/solver.hpp"
#include "tests/proof/impact.hpp"
#include "tests/proof/lab.hpp"
#include "tests/run/runs.hpp"

namespace eerie::step {
namespace {

using nlohmann::json;
using test::small_scene;

/// Changes over a run, relative to natural scales.
struct Drift {
  double momentum, angular_momentum, energy;
};

/// Runs the impact of `changes` to `end_s` and compares its totals with those of the start.
Drift drift_over_impact(const json& changes, double end_s) {
  const Scene scene = small_scene(changes);
  const proof::ImpactEnd end = proof::followed(scene, end_s);
  EXPECT_FALSE(end.failed) << end.failure;
  const double speed = scene.impact.v_imp_cm_per_s / 100;
  return {norm(end.last.momentum - end.first.momentum) / (end.first.mass * speed),
          end.angular_momentum_drift, end.energy_drift};
}

TEST(Impact, ConservesMomentumAndAngularMomentum) {
  for (const char* precision : {"float", "double"}) {
    const Drift d = drift_over_impact({{"numerics", {{"precision", precision}}}}, 3000);
    RecordProperty(std::string("momentum_") + precision, std::to_string(1e6 * d.momentum));
    RecordProperty(std::string("angular_momentum_") + precision,
                   std::to_string(1e6 * d.angular_momentum));
    RecordProperty(std::string("energy_") + precision, std::to_string(d.energy));
    // Pair forces are equal and opposite; what is left is the tree's error (1e-4 of g, times
    // a few thousand seconds) and float rounding.
    EXPECT_LT(d.momentum, 1e-4) << precision;
    // The dual force is exact for the correction matrix of the same step; it is one step old.
    EXPECT_LT(d.angular_momentum, 1e-3) << precision;
    // Friction and viscosity take energy and nothing gives any.
    EXPECT_LT(d.energy, 0);
  }
}

TEST(Impact, AngularMomentumErrorFallsWithTheTimeStep) {
  // Without gravity, whose tree has a torque of its own, and without rounding.
  const auto drift = [](double cfl) {
    return drift_over_impact({{"environment", {{"self_gravity", false}}},
                              {"numerics", {{"cfl", cfl}, {"precision", "double"}}}},
                             500)
        .angular_momentum;
  };
  const double coarse = drift(0.7), fine = drift(0.175);
  RecordProperty("coarse_1e6", std::to_string(1e6 * coarse));
  RecordProperty("fine_1e6", std::to_string(1e6 * fine));
  // The lag of the correction matrix is one step: first order, so a quarter; half is asked.
  EXPECT_LT(fine, 0.5 * coarse);
}

/// Spins a settled body up and follows it; returns what is left of |L| and of the spin rate.
struct SpinKept {
  double angular_momentum, rate, shape;
};
SpinKept after_rotation(const Scene& scene, double period_s, double turns) {
  const Vec3 omega{0, 0, 2 * pi / period_s};
  particles::State s = initial::make_body(scene, particles::Body::target);
  for (std::size_t i = 0; i < s.size(); ++i) s.v[i] = cross(omega, s.x[i]);
  Solver solver(scene, s);
  struct Spin {
    double L = 0, inertia = 0, size2 = 0, z2 = 0;
  };
  const auto spin = [](const particles::State& state) {
    Spin found;
    Vec3 centre, velocity;
    const auto n = static_cast<double>(state.size());
    for (std::size_t i = 0; i < state.size(); ++i)
      centre += state.x[i] / n, velocity += state.v[i] / n;
    for (std::size_t i = 0; i < state.size(); ++i) {
      const Vec3 r = state.x[i] - centre;
      found.L += cross(r, state.v[i] - velocity).z;
      found.inertia += r.x * r.x + r.y * r.y;
      found.size2 += norm2(r), found.z2 += r.z * r.z;
    }
    return found;
  };
  const Spin first = spin(solver.state());
  while (solver.state().time < turns * period_s) solver.cycle(turns * period_s);
  const Spin last = spin(solver.state());
  return {last.L / first.L, last.L / last.inertia / (first.L / first.inertia),
          (last.z2 / last.size2) / (first.z2 / first.size2)};
}

TEST(RotatingSphere, KeepsItsAngularMomentumSpinAndShape) {
  // A period of 4 h: a third of the spin at which friction of 40 deg fails (2.3 h).
  const SpinKept kept = after_rotation(small_scene(), 4 * 3600, 0.5);
  RecordProperty("angular_momentum", std::to_string(kept.angular_momentum));
  RecordProperty("rate", std::to_string(kept.rate));
  RecordProperty("shape", std::to_string(kept.shape));
  // Without the corrected gradient and its dual force a body like this loses all of its spin
  // within a turn.
  EXPECT_NEAR(kept.angular_momentum, 1, 1e-3);
  EXPECT_NEAR(kept.rate, 1, 0.01);
  EXPECT_NEAR(kept.shape, 1, 0.01);
}

/// Twists a cohesive sphere in its gravest torsional mode, in which two halves turn against each
/// other without any change of volume, and returns the period.
double torsional_period(const Scene& scene, double radius) {
  particles::State s = initial::make_body(scene, particles::Body::target);
  // Lamb's mode (l = 2, n = 1): v_phi ~ j_2(k r) dP_2/dcos, with k R = 2.501.
  const double k = 2.5011 / radius;
  std::vector<Vec3> mode(s.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Vec3& p = s.x[i];
    const double kr = k * norm(p);
    const double j2 = kr < 0.1
                          ? kr * kr / 15
                          : (3 / (kr * kr) - 1) * std::sin(kr) / kr - 3 * std::cos(kr) / (kr * kr);
    // v_phi ~ j2 sin cos in azimuth: (z/r) (-y, x, 0)/r.
    mode[i] = j2 * p.z / norm2(p) * Vec3{-p.y, p.x, 0};
    s.v[i] += 1e-3 * mode[i];
  }
  Solver solver(scene, s);
  const auto amplitude = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < solver.state().size(); ++i)
      sum += dot(solver.state().v[i], mode[solver.state().id[i]]);
    return sum;
  };
  // Two zero crossings are half a period apart; the first comes after a quarter.
  const std::vector<double> crossings = proof::zero_crossings(solver, amplitude, 3, 1000);
  return crossings.size() == 3 ? crossings[2] - crossings[0] : 0;
}

TEST(ElasticSphere, TorsionalOscillationHasThePeriodOfTheory) {
  // The speed of shear waves, sqrt(G/rho) = 2.9 m/s, in a body that cohesion keeps elastic.
  const double speed = std::sqrt(22700.0 / 2700), theory = 2 * pi * 50 / (2.5011 * speed);
  const auto ratio = [&](int particles) {
    // Little viscosity, since it damps; gravity every step, to see the zero crossings.
    const Scene scene = small_scene({{"material", {{"drucker_prager", {{"cohesion_Pa", 1e6}}}}},
                                     {"numerics",
                                      {{"particles_per_target", particles},
                                       {"viscosity_alpha", 0.1},
                                       {"viscosity_beta", 0},
                                       {"cfl", 0.2},
                                       {"gravity_interval", 1}}}});
    return torsional_period(scene, 50) / theory;
  };
  const double coarse = ratio(200), fine = ratio(1500);
  RecordProperty("coarse", std::to_string(coarse));
  RecordProperty("fine", std::to_string(fine));
  // Smoothing lowers the frequency by a part of order (h/R)^2 to h/R: 0.17 at 1,500 particles.
  EXPECT_NEAR(fine, 1, 0.08);
  EXPECT_LT(std::abs(fine - 1), std::abs(coarse - 1));  // and it converges
}

}  // namespace
}  // namespace eerie::step
