#include "analysis/remnants/orbit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/base/constants.hpp"

namespace eerie::remnants {
namespace {

constexpr double m1 = 1.4e9, m2 = 0.6e9;
constexpr double mu = newton_G * (m1 + m2);

/// Two bodies at a relative position and velocity, moving through space together.
Orbit orbit_of(const Vec3& r, const Vec3& v) {
  const PointMass one{m1, {1e4, 2e4, -3e3}, {0.4, -0.1, 0.2}};
  return relative_orbit(one, {m2, one.x + r, one.v + v});
}

/// Time to pericentre (or to a distance) by brute force: leapfrog until the distance, once it is
/// below the 300 m of the start, grows again.
double time_by_integration(Vec3 r, Vec3 v, double dt, double until_distance = 0) {
  const auto pull = [](const Vec3& x) { return (-mu / cubed(norm(x))) * x; };
  for (double t = 0;; t += dt) {
    if (dot(r, v) >= 0 && t > 0 && norm(r) < 300) return t;
    if (norm(r) < until_distance) return t;
    v += 0.5 * dt * pull(r);
    r += dt * v;
    v += 0.5 * dt * pull(r);
  }
}

TEST(Orbit, CircleStaysAtItsDistance) {
  const double r = 300;
  const Orbit orbit = orbit_of({r, 0, 0}, {0, std::sqrt(mu / r), 0});
  EXPECT_TRUE(orbit.bound());
  EXPECT_NEAR(orbit.specific_energy, -mu / (2 * r), 1e-12 * mu / r);
  EXPECT_NEAR(orbit.pericentre, r, 1e-6 * r);
}

TEST(Orbit, ApocentreIsHalfAPeriodAway) {
  const double a = 400, e = 0.6;
  const double speed = std::sqrt(mu / a * (1 - e) / (1 + e));  // at apocentre
  const Orbit orbit = orbit_of({a * (1 + e), 0, 0}, {0, 0, speed});
  EXPECT_NEAR(orbit.pericentre, a * (1 - e), 1e-9 * a);
  EXPECT_NEAR(orbit.time_to_pericentre, pi * std::sqrt(cubed(a) / mu), 1e-6 * orbit.distance);
}

TEST(Orbit, FreeFallFromRestTakesTheKnownTime) {
  const double r = 500;
  const Orbit orbit = orbit_of({0, r, 0}, {});
  EXPECT_EQ(orbit.pericentre, 0);
  EXPECT_NEAR(orbit.time_to_pericentre, pi / 2 * std::sqrt(cubed(r) / (2 * mu)), 1e-6 * r);
}

TEST(Orbit, TimeToPericentreAgreesWithIntegration) {
  const double v_esc = std::sqrt(2 * mu / 300);
  for (const double speed : {0.4, 0.9, 1.0, 1.1, 3.0}) {  // ellipses, parabola, hyperbolas
    const Vec3 r{300, 0, 0}, v = speed * v_esc * Vec3{-0.8, 0.6, 0};
    const Orbit orbit = orbit_of(r, v);
    EXPECT_TRUE(orbit.approaching);
    // The sign of a parabola's energy is rounding.
    if (speed != 1.0) {
      EXPECT_EQ(orbit.bound(), speed < 1) << speed;
    }
    const double wanted = time_by_integration(r, v, 0.01);
    EXPECT_NEAR(orbit.time_to_pericentre, wanted, 1e-3 * wanted) << speed;
  }
}

TEST(Orbit, TimeToReachADistanceAgreesWithIntegration) {
  const double v_esc = std::sqrt(2 * mu / 300);
  for (const double speed : {0.4, 1.0, 3.0}) {
    const Vec3 r{300, 0, 0}, v = speed * v_esc * Vec3{-0.8, 0.3, 0};
    const double wanted = time_by_integration(r, v, 0.01, 150);
    EXPECT_NEAR(time_to_reach(orbit_of(r, v), 150), wanted, 1e-3 * wanted) << speed;
  }
  const Vec3 r{300, 0, 0}, outward = 0.7 * v_esc * Vec3{0.8, 0.6, 0};
  const double there_and_back = time_by_integration(r, outward, 0.05, 200);
  EXPECT_NEAR(time_to_reach(orbit_of(r, outward), 200), there_and_back, 1e-3 * there_and_back);
}

TEST(Orbit, DistancesInsideAndOutOfReach) {
  const Orbit orbit = orbit_of({300, 0, 0}, {0, std::sqrt(mu / 300), 0});
  EXPECT_EQ(time_to_reach(orbit, 400), 0);
  EXPECT_TRUE(std::isinf(time_to_reach(orbit, 200)));
}

TEST(Orbit, RecedingEllipseComesBackAfterTheRestOfItsPeriod) {
  const double v_esc = std::sqrt(2 * mu / 300);
  const Vec3 r{300, 0, 0}, v = 0.7 * v_esc * Vec3{0.8, 0.6, 0};
  const Orbit out = orbit_of(r, v), in = orbit_of(r, -v);
  const double a = -mu / (2 * out.specific_energy);
  EXPECT_FALSE(out.approaching);
  EXPECT_NEAR(out.time_to_pericentre + in.time_to_pericentre, 2 * pi * std::sqrt(cubed(a) / mu),
              1e-6 * in.time_to_pericentre);
}

TEST(Orbit, RecedingHyperbolaNeverComesBack) {
  const double v_esc = std::sqrt(2 * mu / 300);
  const Orbit orbit = orbit_of({300, 0, 0}, {1.2 * v_esc, 0.1 * v_esc, 0});
  EXPECT_FALSE(orbit.bound());
  EXPECT_TRUE(std::isinf(orbit.time_to_pericentre));
}

TEST(Orbit, TogetherKeepsMassAndMomentum) {
  const PointMass sum = together({3, {1, 0, 0}, {0, 2, 0}}, {1, {5, 0, 4}, {0, 0, 8}});
  EXPECT_EQ(sum.mass, 4);
  EXPECT_EQ(sum.x, (Vec3{2, 0, 1}));
  EXPECT_EQ(sum.v, (Vec3{0, 1.5, 2}));
}

}  // namespace
}  // namespace eerie::remnants
