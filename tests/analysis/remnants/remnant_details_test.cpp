#include "analysis/remnants/remnant_details.hpp"

#include <gtest/gtest.h>

#include "analysis/remnants/analysis.hpp"
#include "solver/base/constants.hpp"
#include "tests/analysis/remnants/bodies.hpp"

namespace eerie::remnants {
namespace {

/// A spinning ball of 50 m and one of 40 m, 600 m apart, that move at `speed` (m/s) past it.
io::Snapshot two_balls(double speed) {
  particles::State state = test::empty_state();
  const auto x = test::moved(test::ellipsoid({50, 50, 50}, test::spacing), Mat3::identity(), {});
  test::add(state, x, test::spinning(x, {0, 3e-4, 4e-4}, {}), particles::Body::target);
  test::add_body(state, {40, 40, 40}, {600, 0, 0}, {0, speed, 0}, particles::Body::impactor);
  io::Snapshot snapshot = test::snapshot_of(state);
  snapshot.scene.impact.q = 0.512;
  return snapshot;
}

RemnantDetails details_of(const io::Snapshot& snapshot, std::size_t remnant) {
  return analyse_in_detail(snapshot, nullptr, false).details.at(remnant);
}

TEST(RemnantDetails, OfABallAreThoseOfItsMaterial) {
  const RemnantDetails d = details_of(two_balls(0.1), 0);
  EXPECT_EQ(d.shape_class, shapes::ShapeClass::spherical);
  EXPECT_NEAR(d.box.a, 100, 3);
  EXPECT_NEAR(d.box.b_over_a(), 1, 0.03);
  EXPECT_NEAR(d.bulk_density, 2700, 100);
}

TEST(RemnantDetails, TellTheSpinAndHowFarItIsFromTheShortestAxis) {
  particles::State state = test::empty_state();
  const auto x = test::ellipsoid({90, 60, 40}, test::spacing);
  test::add(state, x, test::spinning(x, {0, 3e-4, 4e-4}, {}), particles::Body::target);
  const RemnantDetails d = details_of(test::snapshot_of(state), 0);
  ASSERT_TRUE(d.spin && d.tilt);
  EXPECT_NEAR(d.spin->y, 3e-4, 1e-9);
  EXPECT_NEAR(d.spin->z, 4e-4, 1e-9);
  EXPECT_NEAR(*d.tilt, std::atan2(3, 4) * 180 / pi, 0.1);
}

TEST(RemnantDetails, HaveNoSpinWhereNothingTurns) {
  const RemnantDetails d = details_of(two_balls(0.1), 1);
  EXPECT_FALSE(d.spin);
  EXPECT_FALSE(d.tilt);
}

TEST(RemnantDetails, GiveTheOrbitAboutTheLargestRemnant) {
  const io::Snapshot slow = two_balls(0.02), fast = two_balls(0.2);
  EXPECT_FALSE(details_of(slow, 0).orbit);
  const RemnantDetails bound = details_of(slow, 1), unbound = details_of(fast, 1);
  ASSERT_TRUE(bound.orbit && unbound.orbit);
  const nlohmann::json near = to_json(bound), far = to_json(unbound);
  const Analysis analysis = analyse(slow);
  const double mu = newton_G * (analysis.remnants[0].mass + analysis.remnants[1].mass);
  // Both start across the line between them: 600 m is an apsis, and v^2/2 - mu/r the energy.
  const double a = 1 / (2 / 600.0 - 0.02 * 0.02 / mu);
  EXPECT_NEAR(near.at("orbit_semi_major_axis_m").get<double>(), a, 1e-3 * a);
  EXPECT_NEAR(near.at("orbit_period_h").get<double>(), 2 * pi * std::sqrt(a * a * a / mu) / 3600,
              1e-2);
  EXPECT_LT(near.at("orbit_eccentricity").get<double>(), 1);
  EXPECT_TRUE(near.at("orbit_v_inf_m_per_s").is_null());
  EXPECT_NEAR(far.at("orbit_v_inf_m_per_s").get<double>(), std::sqrt(0.04 - 2 * mu / 600), 1e-4);
  EXPECT_NEAR(far.at("orbit_pericentre_m").get<double>(), 600, 1);
  EXPECT_GT(far.at("orbit_eccentricity").get<double>(), 1);
  EXPECT_TRUE(far.at("orbit_period_h").is_null());
}

TEST(RemnantDetails, SayHowDeepTheirMatterLay) {
  const io::Snapshot first = two_balls(0.1);
  io::Snapshot last = first;
  last.state = test::shuffled(first.state, 5);
  const Analysis analysis = analyse_in_detail(last, &first, false);
  ASSERT_TRUE(analysis.details[0].depth);
  // Of a ball of radius R: mean R/4; a tenth lies above R (1 - 0.9^(1/3)), a tenth below
  // R (1 - 0.1^(1/3)).
  EXPECT_NEAR(analysis.details[0].depth->mean, 12.5, 0.5);
  EXPECT_NEAR(analysis.details[0].depth->p10, 50 * (1 - std::cbrt(0.9)), 0.5);
  EXPECT_NEAR(analysis.details[0].depth->p90, 50 * (1 - std::cbrt(0.1)), 1);
  EXPECT_FALSE(analyse_in_detail(last, nullptr, false).details[0].depth);
}

TEST(RemnantDetails, AreInJsonOnlyWhereTheyWereAskedFor) {
  const io::Snapshot snapshot = two_balls(0.1);
  EXPECT_FALSE(to_json(analyse(snapshot)).at("remnants").at(0).contains("shape_class"));
  const auto json = to_json(analyse_in_detail(snapshot, nullptr, false)).at("remnants").at(0);
  EXPECT_EQ(json.at("shape_class"), "spherical");
  EXPECT_TRUE(json.at("orbit_eccentricity").is_null());
}

}  // namespace
}  // namespace eerie::remnants
