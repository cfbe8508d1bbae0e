#include "campaign/queries/filter.hpp"

#include <gmock/gmock.h>

#include "campaign/text/closest_names.hpp"
#include "solver/base/error.hpp"
#include "tests/support/impact_database.hpp"

namespace eerie::queries {
namespace {
using testing::HasSubstr;

TEST(ParseCondition, ReadsRangesWithOpenEndsWordsAndNone) {
  const db::Condition range = parse_condition("b_over_a=0.1:0.3");
  EXPECT_EQ(range.column, "b_over_a");
  EXPECT_EQ(range.lo, 0.1);
  EXPECT_EQ(range.hi, 0.3);
  EXPECT_EQ(parse_condition("rank=2:").lo, 2);
  EXPECT_EQ(parse_condition("rank=2:").hi, std::nullopt);
  EXPECT_EQ(parse_condition("x_m=:-5").hi, -5);
  EXPECT_EQ(parse_condition("seed=3").lo, 3);
  EXPECT_THAT(parse_condition("class=hit*, erosion").words,
              testing::ElementsAre("hit*", "erosion"));
  EXPECT_TRUE(parse_condition("period_h=none").empty);
  const db::Condition contrary = parse_condition("seed!=3");
  EXPECT_TRUE(contrary.negated);
  EXPECT_EQ(contrary.column, "seed");
  for (const char* text : {"", "=", "b_over_a", "b_over_a=", "=3", "b_over_a=0.3:0.1"})
    EXPECT_THROW(parse_condition(text), InputError) << text;
}

TEST(ClosestNames, ForgiveMissingUnderscoresAndUnits) {
  const std::vector<std::string> names = {"q", "v_imp_cm_per_s", "b_over_a", "impact.q"};
  EXPECT_THAT(text::closest_names("vimp", names), testing::StartsWith("v_imp_cm_per_s"));
  EXPECT_THAT(text::closest_names("B_ovr_a", names), testing::StartsWith("b_over_a"));
}

class Filtered : public testing::Test {
 protected:
  Filtered() {
    test::add_impact(connection, test::survey_scene(1, 40, 20, 15, 1), 0.25);
    test::add_impact(connection, test::survey_scene(1, 40, 30, 15, 1), 0.6);
  }
  std::size_t count(db::View view, const Filter& arguments) {
    return db::rows(connection, filtered(connection, view, arguments)).rows.size();
  }
  std::string refusal(db::View view, const Filter& arguments) {
    try {
      filtered(connection, view, arguments);
    } catch (const InputError& error) {
      return error.what();
    }
    return "taken";
  }
  Filter where(const std::string& text) {
    Filter arguments;
    arguments.where = {text};
    return arguments;
  }

  test::TemporaryFolder folder;
  db::Connection connection{folder / "a.sqlite", db::Access::write};
};

TEST_F(Filtered, EveryViewByTheSameOptions) {
  Filter eer, fast, survey, sketch;
  eer.eer = true;
  fast.v = "25:35";
  survey.fidelity = "survey", sketch.fidelity = "sketch";
  for (const db::View view : {db::View::results, db::View::remnants, db::View::maps}) {
    EXPECT_EQ(count(view, {}), 2u);
    EXPECT_EQ(count(view, eer), 1u);
    EXPECT_EQ(count(view, fast), 1u);
    EXPECT_EQ(count(view, where("b_over_a=:0.3")), 1u);
  }
  EXPECT_EQ(count(db::View::remnants, survey), 2u);
  EXPECT_EQ(count(db::View::remnants, sketch), 0u);
  EXPECT_EQ(count(db::View::remnants, where("class=perfect*")), 2u);
  EXPECT_EQ(count(db::View::results, where("solver_version=0.1.0")), 2u);
  EXPECT_EQ(count(db::View::results, where("eer=true")), 1u);
  EXPECT_EQ(count(db::View::results, where("eer=1")), 1u);
  EXPECT_EQ(count(db::View::results, where("eer=false")), 1u);
}

TEST_F(Filtered, SaysWhatIsWrongWithAFilter) {
  using db::View;
  EXPECT_THAT(refusal(View::results, where("b_ovr_a=0:1")), HasSubstr("the closest are b_over_a"));
  EXPECT_THAT(refusal(View::results, where("b_over_a=low")), HasSubstr("b_over_a is a number"));
  EXPECT_THAT(refusal(View::results, where("eer=maybe")), HasSubstr("give eer=true, eer=false"));
  Filter a;
  a.outcome_class = "explosion";
  EXPECT_THAT(refusal(View::results, a), HasSubstr("must be one of perfect-merging"));
  a.outcome_class = "erosion";
  EXPECT_EQ(refusal(View::remnants, a), "taken");
  EXPECT_EQ(refusal(View::maps, a), "taken");
  EXPECT_THAT(refusal(View::maps, where("end_reason=settled")), HasSubstr("--of results has"));
  Filter sweep;
  sweep.sweep = "nowhere";
  EXPECT_THAT(refusal(View::results, sweep), HasSubstr("has no sweep of this name"));
  Filter fidelity;
  fidelity.fidelity = "sharp";
  EXPECT_THAT(refusal(View::results, fidelity),
              HasSubstr("must be one of sketch, survey, standard, fine, paper"));
}

TEST_F(Filtered, ColumnsAndKeysAreThoseOfTheView) {
  const auto known = db::columns(connection, db::View::remnants);
  const auto keys = parse_sort("rank, -mass_kg", db::View::remnants, known);
  ASSERT_EQ(keys.size(), 2u);
  EXPECT_FALSE(keys[0].descending);
  EXPECT_TRUE(keys[1].descending);
  EXPECT_EQ(keys[1].column, "mass_kg");
  EXPECT_THAT(parse_columns("job,rank", db::View::remnants, known),
              testing::ElementsAre("job", "rank"));
  EXPECT_THROW(parse_sort("--rank", db::View::remnants, known), InputError);
  for (const char* text : {"job,job", "job,,rank", "class", "rank;"})
    EXPECT_THROW(parse_columns(text, db::View::remnants, known), InputError) << text;
}

}  // namespace
}  // namespace eerie::queries
