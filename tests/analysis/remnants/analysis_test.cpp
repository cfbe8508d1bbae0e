#include "analysis/remnants/analysis.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "analysis/remnants/meetings.hpp"
#include "solver/base/constants.hpp"
#include "tests/analysis/remnants/bodies.hpp"

namespace eerie::remnants {
namespace {

using test::add_body;
using test::empty_state;
using test::snapshot_of;
using testing::HasSubstr;

const Vec3 ball{30, 30, 30};

/// Two equal balls, `distance` apart along x, in relative motion.
Analysis two_balls(double distance, const Vec3& relative_velocity) {
  particles::State state = empty_state();
  add_body(state, ball, {}, {1, 2, 3}, particles::Body::target);
  add_body(state, ball, {distance, 0, 0}, Vec3{1, 2, 3} + relative_velocity,
           particles::Body::impactor);
  return analyse(snapshot_of(state));
}
double v_esc_of_two_balls(double distance) {
  const double n = static_cast<double>(test::ellipsoid(ball, test::spacing).size());
  return std::sqrt(2 * newton_G * 2 * n * test::particle_mass_kg / distance);
}

TEST(Analysis, OneSpinningEllipsoidIsMeasuredWhole) {
  particles::State state = empty_state();
  const auto x = test::moved(test::ellipsoid({100, 25, 25}, test::spacing),
                             test::rotation({1, 2, 3}, 0.8), {500, -700, 900});
  const double omega = 2 * pi / (9.36 * 3600);
  test::add(state, x, test::spinning(x, test::rotation({1, 2, 3}, 0.8) * Vec3{0, 0, omega}, {}),
            particles::Body::target);
  for (std::size_t i = 0; i < x.size() / 2; ++i) state.body[i] = 1;
  const Analysis found = analyse(snapshot_of(state));
  ASSERT_EQ(found.remnants.size(), 1u);
  const Remnant& r = found.remnants[0];
  EXPECT_EQ(r.particles, x.size());
  EXPECT_NEAR(r.mass, static_cast<double>(x.size()) * test::particle_mass_kg, 1);
  EXPECT_NEAR(r.shape.b_over_a(), 0.25, 0.01);
  EXPECT_TRUE(r.eer);
  EXPECT_NEAR(r.spin_period.value() / 3600, 9.36, 1e-6);
  EXPECT_NEAR(r.target_fraction, 0.5, 0.001);
  EXPECT_NEAR(r.x.y, -700, 1e-6);
  EXPECT_EQ(found.outcome, OutcomeClass::perfect_merging);
  EXPECT_TRUE(found.settled);
}

TEST(Analysis, BoundPairIsTwoRoundRemnantsMergedButUnsettled) {
  const Analysis found = two_balls(200, {0.5 * v_esc_of_two_balls(200), 0, 0});
  ASSERT_EQ(found.remnants.size(), 2u);
  for (const Remnant& r : found.remnants) {
    EXPECT_NEAR(r.shape.b_over_a(), 1, 1e-6) << "never one long ellipsoid";
    EXPECT_FALSE(r.eer);
    EXPECT_EQ(r.bound_group, 1);
    EXPECT_NEAR(r.mass_over_total, 0.5, 1e-12);
    EXPECT_NEAR(r.bound_mass_over_total, 1, 1e-12);
  }
  EXPECT_EQ(found.outcome, OutcomeClass::perfect_merging);
  EXPECT_NEAR(found.m_lr_over_m_total, 1, 1e-12);
  EXPECT_EQ(found.m_slr_over_m_total, 0);
  EXPECT_FALSE(found.settled);
  EXPECT_THAT(found.unsettled_reason,
              HasSubstr("remnants 1 and 2 (0.500 and 0.500 of the mass) are bound to each other, "
                        "200 m apart and will meet in about"));
  EXPECT_TRUE(will_meet(found.remnants, 0.005));
  // Fragments are not waited for.
  EXPECT_FALSE(will_meet(found.remnants, 0.5));
  EXPECT_EQ(unsettled_reason(found.remnants, 0.5), "");
}

TEST(Analysis, PairThatEscapesIsSettledHitAndRun) {
  const Analysis found = two_balls(200, {1.1 * v_esc_of_two_balls(200), 0, 0});
  EXPECT_EQ(found.outcome, OutcomeClass::hit_and_run);
  EXPECT_NEAR(found.m_slr_over_m_total, 0.5, 1e-12);
  EXPECT_EQ(found.remnants[1].bound_group, 2);
  EXPECT_TRUE(found.settled) << found.unsettled_reason;
  EXPECT_FALSE(will_meet(found.remnants, 0.005));
}

TEST(Analysis, PairOnItsWayToAnImpactIsUnsettled) {
  const double v = 2 * v_esc_of_two_balls(200);
  const Analysis found = two_balls(200, {-v, 0.1 * v, 0});
  EXPECT_FALSE(found.settled);
  EXPECT_THAT(found.unsettled_reason, HasSubstr("closing in on each other"));
}

TEST(Analysis, PairThatWillMissIsSettled) {
  const double v = 2 * v_esc_of_two_balls(200);
  EXPECT_TRUE(two_balls(200, {-0.5 * v, v, 0}).settled);
}

TEST(Analysis, WideBinaryIsUnsettledWithItsPericentre) {
  const double circular = v_esc_of_two_balls(300) / std::sqrt(2);
  const Analysis found = two_balls(300, {0, circular, 0});
  EXPECT_FALSE(found.settled);
  EXPECT_THAT(found.unsettled_reason, HasSubstr("their pericentre of 300 m is outside of contact"));
  EXPECT_FALSE(will_meet(found.remnants, 0.005));  // waiting for it would not end
}

TEST(Analysis, PairThatOnlyAGroupHoldsTogetherIsSaidToPartByItself) {
  const double v = 1.1 * v_esc_of_two_balls(200);
  std::vector<Remnant> remnants = two_balls(200, {v, 0.01 * v, 0}).remnants;
  EXPECT_EQ(unsettled_reason(remnants, 0.005), "");
  for (Remnant& r : remnants) r.bound_group = 1;
  EXPECT_THAT(unsettled_reason(remnants, 0.005),
              testing::EndsWith("by themselves the two would part"));
}

TEST(Analysis, DebrisIsNoRemnantButCountsForTheMass) {
  particles::State state = empty_state();
  add_body(state, {60, 60, 60}, {}, {}, particles::Body::target);
  add_body(state, {10, 10, 10}, {150, 0, 0}, {}, particles::Body::impactor);           // falls back
  add_body(state, {10, 10, 10}, {-150, 0, 0}, {-9, 0, 0}, particles::Body::impactor);  // leaves
  const Analysis found = analyse(snapshot_of(state));
  const double small = static_cast<double>(test::ellipsoid({10, 10, 10}, test::spacing).size());
  const double all = static_cast<double>(state.size());
  ASSERT_EQ(found.remnants.size(), 1u);
  EXPECT_NEAR(found.debris_bound_over_total, small / all, 1e-12);
  EXPECT_NEAR(found.m_lr_over_m_total, 1 - small / all, 1e-12);
  EXPECT_NEAR(found.m_slr_over_m_total, small / all, 1e-12);
  EXPECT_NEAR(found.remnants[0].mass_over_total, 1 - 2 * small / all, 1e-12);
  EXPECT_EQ(found.remnants[0].target_fraction, 1);
  EXPECT_TRUE(found.settled);
}

TEST(Analysis, HundredParticlesMakeARemnantAndNinetyNineDoNot) {
  const auto remnants = [](int n) {
    particles::State state = empty_state();
    for (int i = 0; i < n; ++i) {
      const Vec3 x{test::spacing * (i % 10), test::spacing * (i / 10), 0.1 * (i % 3)};
      test::add(state, {x}, {Vec3{}}, i % 2 ? particles::Body::target : particles::Body::impactor);
    }
    return analyse(snapshot_of(state)).remnants.size();
  };
  EXPECT_EQ(remnants(100), 1u);
  EXPECT_EQ(remnants(99), 0u);
}

TEST(Analysis, EveryRemnantMayBeAnEer) {
  particles::State state = empty_state();
  add_body(state, {50, 50, 50}, {}, {}, particles::Body::target);
  add_body(state, {90, 20, 20}, {1000, 0, 0}, {5, 0, 0}, particles::Body::impactor);
  const Analysis found = analyse(snapshot_of(state));
  ASSERT_EQ(found.remnants.size(), 2u);
  EXPECT_FALSE(found.remnants[0].eer);
  EXPECT_TRUE(found.remnants[1].eer);
}

TEST(Analysis, RestingRemnantHasNoPeriod) {
  particles::State state = empty_state();
  add_body(state, ball, {}, {}, particles::Body::target);
  add_body(state, ball, {500, 0, 0}, {0.1, 0.2, 0.3}, particles::Body::impactor);
  const Analysis found = analyse(snapshot_of(state));
  EXPECT_FALSE(found.remnants[0].spin_period);
  EXPECT_FALSE(found.remnants[1].spin_period) << "rounding of a common drift is no spin";
  EXPECT_TRUE(to_json(found)["remnants"][0]["spin_period_h"].is_null());
}

TEST(Analysis, MemoryOrderChangesNoBit) {
  particles::State state = empty_state();
  add_body(state, {60, 40, 40}, {}, {0.01, 0, 0}, particles::Body::target);
  add_body(state, ball, {110, 20, 5}, {-0.02, 0.03, 0}, particles::Body::impactor);
  add_body(state, {12, 12, 12}, {300, 0, 0}, {0.1, 0, 0}, particles::Body::impactor);
  Random random(5, 5);
  for (Vec3& v : state.v) v += 0.01 * random.direction();
  const auto json = to_json(analyse(snapshot_of(state)));
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    EXPECT_EQ(to_json(analyse(snapshot_of(test::shuffled(state, seed)))), json);
}

TEST(Analysis, JsonHasExactlyTheFieldsPromised) {
  particles::State state = empty_state();
  add_body(state, ball, {}, {}, particles::Body::target);
  add_body(state, ball, {200, 0, 0}, {9, 0, 0}, particles::Body::impactor);
  const nlohmann::json json = to_json(analyse(snapshot_of(state)));
  const auto keys = [](const nlohmann::json& object) {
    std::vector<std::string> all;
    for (const auto& item : object.items()) all.push_back(item.key());
    return all;
  };
  EXPECT_THAT(keys(json), testing::UnorderedElementsAre("outcome", "remnants"));
  EXPECT_THAT(keys(json["outcome"]),
              testing::UnorderedElementsAre("class", "m_lr_over_m_total", "m_slr_over_m_total",
                                            "settled", "unsettled_reason"));
  EXPECT_THAT(
      keys(json["remnants"][1]),
      testing::UnorderedElementsAre("rank", "particles", "mass_kg", "mass_over_total", "a_m", "b_m",
                                    "c_m", "b_over_a", "c_over_a", "spin_period_h", "eer",
                                    "target_fraction", "bound_group", "bound_mass_over_total",
                                    "x_m", "y_m", "z_m", "vx_m_per_s", "vy_m_per_s", "vz_m_per_s"));
  EXPECT_EQ(json["outcome"]["class"], "hit-and-run");
  EXPECT_EQ(json["outcome"]["unsettled_reason"], "");
  EXPECT_EQ(json["remnants"][1]["rank"], 2);
}

}  // namespace
}  // namespace eerie::remnants
