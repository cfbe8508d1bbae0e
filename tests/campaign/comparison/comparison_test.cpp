#include "campaign/comparison/comparison.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "campaign/comparison/comparison_table.hpp"
#include "solver/base/error.hpp"
#include "tests/support/impact_database.hpp"

namespace eerie::comparison {
namespace {
using testing::HasSubstr;
using testing::ThrowsMessage;

statistics::Ensemble over(const std::vector<double>& values) {
  return statistics::ensemble(values);
}

TEST(SeedsCompared, HaveTheChanceOfWelchsTest) {
  // Means 2 and 4, both of variance 1: t = 2 / sqrt(2/3) = sqrt(6) with 4 degrees of freedom.
  // With x = t / sqrt(4 + t^2), P(|T| > t) = 1 - (3 x - x^3) / 2 for those.
  const SeedsCompared apart{over({1, 2, 3}), over({3, 4, 5})};
  const double x = std::sqrt(6 / 10.0);
  EXPECT_NEAR(apart.chance().value(), 1 - (3 * x - x * x * x) / 2, 1e-6);
  EXPECT_EQ(apart.difference(), 2);
  EXPECT_FALSE(apart.is_beyond_scatter());
  // Twice as far apart: t = 2 sqrt(6).
  EXPECT_TRUE((SeedsCompared{over({1, 2, 3}), over({5, 6, 7})}).is_beyond_scatter());
}

TEST(SeedsCompared, HoldASingleRunAgainstTheScatterOfTheOthers) {
  // t = (8 - 2) / sqrt(1 + 1/3) with 2 degrees of freedom; P(|T| > t) = 1 - t / sqrt(2 + t^2).
  const double t = 6 / std::sqrt(4 / 3.0);
  for (const SeedsCompared& one :
       {SeedsCompared{over({8}), over({1, 2, 3})}, SeedsCompared{over({1, 2, 3}), over({8})}})
    EXPECT_NEAR(one.chance().value(), 1 - t / std::sqrt(2 + t * t), 1e-6);
}

TEST(SeedsCompared, SayNothingWhereNothingIsKnown) {
  EXPECT_EQ((SeedsCompared{over({1}), over({2})}).chance(), std::nullopt);
  EXPECT_EQ((SeedsCompared{over({}), over({2, 3})}).difference(), std::nullopt);
  EXPECT_FALSE((SeedsCompared{over({}), over({2, 3})}).is_beyond_scatter());
  // Without any scatter every difference is beyond it.
  EXPECT_EQ((SeedsCompared{over({1, 1}), over({1, 1})}).chance(), 1);
  EXPECT_EQ((SeedsCompared{over({1, 1}), over({2, 2})}).chance(), 0);
}

class Sides : public testing::Test {
 protected:
  static void add(db::Connection& to, double v, std::vector<double> b_over_a, bool fine = false) {
    int seed = 0;
    for (const double shape : b_over_a) {
      nlohmann::json scene = test::survey_scene(1, 40, v, 15, ++seed);
      if (fine) scene["numerics"]["particles_per_target"] = 2345;
      test::add_impact(to, scene, shape);
    }
  }
  test::TemporaryFolder folder;
  db::Connection a{folder / "a.sqlite", db::Access::write};
  db::Connection b{folder / "b.sqlite", db::Access::write};
};

TEST_F(Sides, AreComparedImpactByImpact) {
  add(a, 20, {0.30, 0.31, 0.32}), add(b, 20, {0.70, 0.71, 0.72});
  add(a, 25, {0.5, 0.6}), add(b, 25, {0.5, 0.6});
  add(a, 15, {0.5}), add(b, 30, {0.5}), add(b, 31, {0.5});
  const Compared all = compare({&a}, {&b});
  ASSERT_EQ(all.impacts.size(), 2u);
  EXPECT_EQ(all.only_a, 1u);
  EXPECT_EQ(all.only_b, 2u);
  EXPECT_EQ(all.impacts[0].v_imp_cm_per_s, 20);
  EXPECT_NEAR(all.impacts[0].b_over_a.difference().value(), 0.4, 1e-12);
  EXPECT_TRUE(all.impacts[0].is_beyond_scatter());
  EXPECT_EQ(all.impacts[0].same_jobs, 3u);
  EXPECT_EQ(all.impacts[0].same_results, 0u);
  EXPECT_FALSE(all.impacts[1].is_beyond_scatter());
  EXPECT_EQ(all.impacts[1].same_results, 2u);
  EXPECT_THAT(summary(all), HasSubstr("2 impacts: the class differs in 0; 1 beyond the scatter"));
  const auto records = text::records(table_of_impacts(all));
  EXPECT_NEAR(records.at(0).at("b_over_a_difference").get<double>(), 0.4, 1e-12);
  EXPECT_EQ(records.at(0).at("beyond_scatter"), true);
}

TEST_F(Sides, OfOtherSettingsAreComparedWhereTheyAreChosen) {
  add(a, 20, {0.3, 0.31}), add(a, 20, {0.5, 0.51}, true);
  add(b, 20, {0.5, 0.51}, true);
  // Without a choice, like with like.
  const Compared like = compare({&a}, {&b});
  ASSERT_EQ(like.impacts.size(), 1u);
  EXPECT_EQ(like.impacts[0].b_over_a.difference(), 0);
  const Compared within = compare({&a, "survey"}, {&a, "2"});
  ASSERT_EQ(within.impacts.size(), 1u);
  EXPECT_EQ(within.impacts[0].settings_a, "survey");
  EXPECT_EQ(within.impacts[0].settings_b, "settings 2");
  EXPECT_NEAR(within.impacts[0].b_over_a.difference().value(), 0.2, 1e-12);
}

TEST_F(Sides, WithNothingInCommonAreRefusedWithWhatThereIs) {
  add(a, 20, {0.3}), add(b, 20, {0.5}, true);
  EXPECT_THAT([&] { compare({&a}, {&b}); },
              ThrowsMessage<InputError>(testing::AllOf(
                  HasSubstr("with survey"), HasSubstr("settings 1"), HasSubstr("--of"))));
  EXPECT_THAT(
      [&] {
        compare({&a, "fine"}, {&b});
      },
      ThrowsMessage<InputError>(HasSubstr("no result of the settings \"fine\"")));
}

}  // namespace
}  // namespace eerie::comparison
