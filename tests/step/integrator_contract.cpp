#include <gtest/gtest.h>

#include <cmath>

#include "solver/step/integrator.hpp"
#include "tests/support/variant_types.hpp"

namespace eerie::step {
namespace {

/// A damped anharmonic oscillator with a force that depends on position, speed and an internal
/// stress, like that of a particle, whose rate of strain depends on where it is:
/// x' = v, v' = -x - 0.3 x^3 + s - 0.1 v, s' = -(1 + 0.2 x) v - 0.5 s.
struct Oscillator {
  double x = 1, v = 0, s = 0;
  double dv_dt = 0, ds_dt = 0;
  int evaluations = 0;

  Oscillator() { evaluate(0); }
  void kick(double duration) { v += duration * dv_dt, s += duration * ds_dt; }
  void kick_and_drift(double duration, double drift) {
    kick(duration);
    x += drift * v;
  }
  void evaluate(double ahead) {
    const double w = v + ahead * dv_dt, t = s + ahead * ds_dt;
    dv_dt = -x - 0.3 * x * x * x + t - 0.1 * w;
    ds_dt = -(1 + 0.2 * x) * w - 0.5 * t;
    ++evaluations;
  }
  void push(double duration) { v += duration * dv_dt; }
  void push_and_drift(double duration, double drift) {
    push(duration);
    x += drift * v;
  }
  void deform(double duration) {
    const double middle = x - duration / 2 * v, strain = -(1 + 0.2 * middle) * v;
    const double half = s + duration / 2 * (strain - 0.5 * s);
    s += duration * (strain - 0.5 * half);
  }
  void exert(double ahead) {
    dv_dt = -x - 0.3 * x * x * x + s - 0.1 * (v + ahead * dv_dt);
    ++evaluations;
  }
};

template <class Integrator>
Oscillator after(double time, int steps) {
  Oscillator system;
  for (int n = 0; n < steps; ++n) Integrator::step(system, time / steps);
  return system;
}

/// A solution of fourth order with steps so short that its error is rounding.
Oscillator exact(double time) {
  struct Rate {
    double x, v, s;
  };
  const auto rate = [](const Oscillator& o) {
    return Rate{o.v, -o.x - 0.3 * o.x * o.x * o.x + o.s - 0.1 * o.v,
                -(1 + 0.2 * o.x) * o.v - 0.5 * o.s};
  };
  const auto moved = [](Oscillator o, const Rate& r, double dt) {
    o.x += dt * r.x, o.v += dt * r.v, o.s += dt * r.s;
    return o;
  };
  Oscillator o;
  const int steps = 20000;
  const double dt = time / steps;
  for (int n = 0; n < steps; ++n) {
    const Rate a = rate(o), b = rate(moved(o, a, dt / 2)), c = rate(moved(o, b, dt / 2)),
               d = rate(moved(o, c, dt));
    o = moved(o,
              {(a.x + 2 * b.x + 2 * c.x + d.x) / 6, (a.v + 2 * b.v + 2 * c.v + d.v) / 6,
               (a.s + 2 * b.s + 2 * c.s + d.s) / 6},
              dt);
  }
  return o;
}

template <class Integrator>
class IntegratorContract : public testing::Test {};
TYPED_TEST_SUITE(IntegratorContract, test::AlternativesOf<Integrator>, test::NameByToken);

TYPED_TEST(IntegratorContract, ErrorFallsWithItsOrder) {
  const Oscillator truth = exact(10);
  const auto error = [&](int steps) {
    const Oscillator o = after<TypeParam>(10, steps);
    return std::hypot(o.x - truth.x, o.v - truth.v, o.s - truth.s);
  };
  // Error ~ dt^order + higher: at these steps the measured exponent is within a tenth.
  EXPECT_NEAR(std::log2(error(400) / error(800)), TypeParam::order, 0.1);
  EXPECT_NEAR(std::log2(error(800) / error(1600)), TypeParam::order, 0.1);
}

TYPED_TEST(IntegratorContract, CostsTheEvaluationsItSays) {
  const int first = Oscillator().evaluations;
  EXPECT_EQ(after<TypeParam>(1, 10).evaluations - first, 10 * TypeParam::evaluations);
}

TYPED_TEST(IntegratorContract, MovesUniformlyToTheLastDigits) {
  // Without forces a drift is exact but for rounding.
  struct Free {
    double x = 0, v = 0.25;
    void kick(double) {}
    void kick_and_drift(double, double drift) { x += drift * v; }
    void evaluate(double) {}
    void push(double) {}
    void push_and_drift(double, double drift) { x += drift * v; }
    void deform(double) {}
    void exert(double) {}
  } system;
  for (int n = 0; n < 64; ++n) TypeParam::step(system, 0.5);
  EXPECT_EQ(system.x, 8);
}

}  // namespace
}  // namespace eerie::step
