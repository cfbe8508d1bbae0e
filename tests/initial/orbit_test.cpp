#include "solver/initial/orbit.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/initial/bodies.hpp"
#include "tests/support/scenes.hpp"

namespace eerie::initial {
namespace {

struct Case {
  const char* name;
  double q, v_imp, theta_deg, distance;  // m/s; distance in contact distances
};
/// Target of 50 m and 2700 kg/m^3; the escape speeds at contact are 6.1 to 5.4 cm/s.
constexpr Case cases[] = {{"reference", 1, 0.20, 15, 2},     {"head-on", 1, 0.20, 0, 2},
                          {"grazing", 1, 0.10, 80, 3},       {"small impactor", 0.25, 0.15, 30, 2},
                          {"far away", 0.5, 0.12, 45, 20},   {"bound, reachable", 1, 0.055, 20, 2},
                          {"bound, head-on", 1, 0.05, 0, 2}, {"parabolic", 1, 0.0614, 40, 5}};

double contact_of(const Case& c) { return 50 * (1 + std::cbrt(c.q)); }
double mu_of(const Case& c) { return newton_G * 2700 * sphere_volume(50) * (1 + c.q); }
RelativeOrbit contact_orbit(const Case& c) {
  return orbit_at_contact(contact_of(c), c.v_imp, radians(c.theta_deg));
}
RelativeOrbit start_of(const Case& c) {
  return orbit_before_contact(contact_orbit(c), mu_of(c), c.distance * contact_of(c));
}

double energy(const RelativeOrbit& o, double mu) {
  return 0.5 * norm2(o.velocity) - mu / norm(o.position);
}

TEST(OrbitAtContact, HasSpeedAngleAndDistanceAsAsked) {
  for (const Case& c : cases) {
    const RelativeOrbit o = contact_orbit(c);
    EXPECT_NEAR(norm(o.position), contact_of(c), 1e-12);
    EXPECT_DOUBLE_EQ(norm(o.velocity), c.v_imp);
    const double angle =
        std::acos(std::min(1.0, -dot(o.position, o.velocity) / norm(o.position) / c.v_imp));
    EXPECT_NEAR(degrees(angle), c.theta_deg, 1e-6) << c.name;  // acos near 0 keeps half the digits
    EXPECT_GE(cross(o.position, o.velocity).z, 0) << c.name;
  }
}

TEST(OrbitBeforeContact, KeepsEnergyAndAngularMomentumAtTheDistanceAsked) {
  for (const Case& c : cases) {
    const RelativeOrbit start = start_of(c), end = contact_orbit(c);
    const double mu = mu_of(c), scale = c.v_imp * contact_of(c);
    EXPECT_NEAR(norm(start.position) / (c.distance * contact_of(c)), 1, 1e-14) << c.name;
    EXPECT_NEAR(energy(start, mu), energy(end, mu), 1e-14 * c.v_imp * c.v_imp + 1e-17) << c.name;
    const Vec3 change = cross(start.position, start.velocity) - cross(end.position, end.velocity);
    EXPECT_LT(norm(change), 1e-13 * scale) << c.name;
    EXPECT_LT(dot(start.position, start.velocity), 0) << c.name << ": must be closing in";
  }
}

/// One step of the classical Runge-Kutta rule for two bodies.
RelativeOrbit advanced(const RelativeOrbit& o, double mu, double dt) {
  const auto slope = [mu](const RelativeOrbit& s) {
    return RelativeOrbit{s.velocity, -mu / cubed(norm(s.position)) * s.position};
  };
  const auto plus = [&](const RelativeOrbit& k, double step) {
    return RelativeOrbit{o.position + step * k.position, o.velocity + step * k.velocity};
  };
  const RelativeOrbit k1 = slope(o), k2 = slope(plus(k1, dt / 2)), k3 = slope(plus(k2, dt / 2)),
                      k4 = slope(plus(k3, dt));
  return {o.position + dt / 6 * (k1.position + 2 * k2.position + 2 * k3.position + k4.position),
          o.velocity + dt / 6 * (k1.velocity + 2 * k2.velocity + 2 * k3.velocity + k4.velocity)};
}

TEST(OrbitBeforeContact, LeadsToContactWithTheSpeedAndAngleAsked) {
  for (const Case& c : cases) {
    RelativeOrbit o = start_of(c);
    const double mu = mu_of(c), contact = contact_of(c), dt = 1e-3 * contact / c.v_imp;
    int steps = 0;
    while (norm(o.position) > contact && steps < 1000000) o = advanced(o, mu, dt), ++steps;
    ASSERT_LT(steps, 1000000) << c.name << ": never met";
    EXPECT_GT(steps, 100) << c.name;
    // Back onto the contact sphere, by Newton's method in time.
    for (int n = 0; n < 5; ++n) {
      const double r = norm(o.position), radial = dot(o.position, o.velocity) / r;
      o = advanced(o, mu, (contact - r) / radial);
    }
    const RelativeOrbit asked = contact_orbit(c);
    // Runge-Kutta of fourth order with a thousand steps per contact distance: below 1e-9.
    EXPECT_LT(norm(o.velocity - asked.velocity), 1e-8 * c.v_imp) << c.name;
    EXPECT_LT(norm(o.position - asked.position), 1e-8 * contact) << c.name;
  }
}

TEST(OrbitBeforeContact, AnOrbitThatNeverWasThatFarIsRefusedWithItsField) {
  // 3 cm/s is bound, with apocentre at 1.3 contact distances when head-on.
  for (const double theta : {0.0, 20.0}) try {
      start_of({"bound", 1, 0.03, theta, 2});
      FAIL() << "theta " << theta;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(),
                  testing::AllOf(testing::HasSubstr("scene.impact.v_imp_cm_per_s = 3"),
                                 testing::HasSubstr("impact.separation")));
    }
  // The very same orbit is fine where it has been.
  EXPECT_NO_THROW(start_of({"bound", 1, 0.03, 0, 1.25}));
}

TEST(MakeImpact, RefusesAnUnreachableOrbitBeforeItBuildsBodies) {
  EXPECT_THROW(make_impact(test::small_scene({{"impact", {{"v_imp_cm_per_s", 3}}},
                                              {"numerics", {{"particles_per_target", 10000000}}}})),
               InputError);
}

/// Points in the pull of a primary at rest, forward in time by small steps: independent of frames.
struct ThreeBodies {
  Vec3 target, impactor, target_v, impactor_v;
};

TEST(OrbitBeforeContact, InATideLeadsToTheContactThatWasAskedFor) {
  const double M = 4.95e11, d = 1000;
  for (const Case& c : cases) {
    if (c.v_imp < 0.06 || c.distance > 3) continue;  // those that the tide lets go
    for (const bool retrograde : {false, true}) {
      const Tide tide({M, 360, d, 70, retrograde});
      const double share = c.q / (1 + c.q), m = mu_of(c) / newton_G;
      const RelativeOrbit start =
          orbit_before_contact(contact_orbit(c), mu_of(c), c.distance * contact_of(c), tide, share);
      EXPECT_NEAR(norm(start.position), c.distance * contact_of(c), 1e-9) << c.name;
      // The primary is at the origin; the middle of the bodies goes about it.
      const Vec3 middle = -tide.place(0), middle_v = cross({0, 0, tide.rate()}, middle);
      ThreeBodies b{middle - share * start.position, middle + (1 - share) * start.position,
                    middle_v - share * start.velocity, middle_v + (1 - share) * start.velocity};
      const auto pull = [&](const Vec3& at, const Vec3& by, double mass) {
        const Vec3 to = by - at;
        return newton_G * mass / (norm2(to) * norm(to)) * to;
      };
      const double dt = 0.05;
      double time = 0;
      while (norm(b.impactor - b.target) > contact_of(c)) {
        time += dt;
        ASSERT_LT(time, 1e5) << c.name;
        b.target += dt / 2 * b.target_v, b.impactor += dt / 2 * b.impactor_v;
        b.target_v += dt * (pull(b.target, {}, M) + pull(b.target, b.impactor, m * share));
        b.impactor_v +=
            dt * (pull(b.impactor, {}, M) + pull(b.impactor, b.target, m * (1 - share)));
        b.target += dt / 2 * b.target_v, b.impactor += dt / 2 * b.impactor_v;
      }
      const RelativeOrbit end = contact_orbit(c);
      // The centre of both leaves its circle, as the tide is uneven; and steps are dt v long.
      EXPECT_LT(norm(b.impactor - b.target - end.position), 0.005 * contact_of(c)) << c.name;
      EXPECT_LT(norm(b.impactor_v - b.target_v - end.velocity), 1e-3 * c.v_imp) << c.name;
    }
  }
}

TEST(OrbitBeforeContact, InAFaintTideIsThatOfKepler) {
  const Case& c = cases[0];
  const RelativeOrbit with = orbit_before_contact(
      contact_orbit(c), mu_of(c), c.distance * contact_of(c), Tide({1, 1, 1e6, 0, false}), 0.5);
  EXPECT_LT(norm(with.position - start_of(c).position), 1e-6);
  EXPECT_LT(norm(with.velocity - start_of(c).velocity), 1e-9);
}

TEST(OrbitBeforeContact, InATideThatNeverLetThemSoFarApartIsRefused) {
  // Below the escape speed of 6.1 cm/s.
  const Tide faint({1, 1, 1e6, 0, false});
  EXPECT_THROW(
      orbit_before_contact(orbit_at_contact(100, 0.05, 0.2), mu_of(cases[0]), 1000, faint, 0.5),
      InputError);
}

}  // namespace
}  // namespace eerie::initial
