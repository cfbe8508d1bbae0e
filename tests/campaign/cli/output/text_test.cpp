#include <gmock/gmock.h>

#include "campaign/cli/commands.hpp"
#include "campaign/cli/options/options.hpp"
#include "campaign/cli/output/progress_line.hpp"
#include "campaign/cli/output/results_table.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace {
using testing::HasSubstr;

db::ResultRow row(double v, double b_over_a) {
  db::ResultRow r;
  r.q = 1;
  r.phi_d_deg = 40;
  r.v_imp_cm_per_s = v;
  r.theta_imp_deg = 15;
  r.particles_per_target = 1000;
  r.result.outcome_class = "perfect-merging";
  r.result.b_over_a = b_over_a;
  r.result.settled = true;
  r.result.eer = b_over_a < 0.3;
  r.result.n_eer = r.result.eer ? 1 : 0;
  return r;
}

TEST(TextTable, AlignsNumbersRightAndWordsLeft) {
  EXPECT_EQ(text_table({{"v", "class"}, {"5", "a"}, {"15", "merge"}}),
            " v  class\n"
            " 5  a\n"
            "15  merge\n");
  EXPECT_EQ(text_table({{"x"}, {"-5"}, {"10"}}), " x\n-5\n10\n");
}

TEST(Duration, IsInTheUnitThatAPersonWouldUse) {
  EXPECT_EQ(duration(5.4), "5 s");
  EXPECT_EQ(duration(200), "3 min 20 s");
  EXPECT_EQ(duration(9000), "2.5 h");
  EXPECT_EQ(duration(86400 * 3), "3.0 days");
}

TEST(Magnitude, HasThreeDigits) {
  EXPECT_EQ(magnitude(1234567), "1.23 M");
  EXPECT_EQ(magnitude(999.9), "1 k");
  EXPECT_EQ(magnitude(12), "12");
}

TEST(ProgressText, ShowsJobsSpeedAndTimeLeft) {
  manager::CampaignView view;
  view.total = 15, view.done = 3, view.failed = 1, view.running = 2;
  view.particle_steps_per_s = 1.9e6;
  view.eta_s = 200;
  EXPECT_EQ(progress_text(view, false),
            "3/15 done, 1 failed, 2 running | 1.9 M particle-steps/s | ETA 3 min 20 s");
  EXPECT_THAT(progress_text(view, true), testing::StartsWith("[######------------------] 3/15"));
}

TEST(ResultsTable, ShowsOnlyParametersThatDiffer) {
  const std::string same = results_table({row(15, 0.5), row(20, 0.6)});
  EXPECT_THAT(same, testing::StartsWith("q 1, phi_d 40 deg, particles per target 1000"));
  db::ResultRow other = row(20, 0.6);
  other.phi_d_deg = 50;
  EXPECT_THAT(results_table({row(15, 0.5), other}), HasSubstr("phi_d  v cm/s"));
}

TEST(ResultsTable, ExplainsEveryMarkThatItUsesAndNoOther) {
  EXPECT_THAT(results_table({row(15, 0.5)}), testing::Not(HasSubstr("extremely elongated")));
  db::ResultRow unsettled = row(20, 0.2);
  unsettled.result.settled = false;
  const std::string table = results_table({unsettled});
  EXPECT_THAT(table, HasSubstr("*  the largest remnant is extremely elongated"));
  EXPECT_THAT(table, HasSubstr("~  not settled"));
}

TEST(ParseDuration, TakesTheUnitsOfPeopleAndNothingElse) {
  EXPECT_EQ(parse_duration("90s", "--wall-limit"), 90);
  EXPECT_EQ(parse_duration("45min", "--wall-limit"), 2700);
  EXPECT_EQ(parse_duration("1.5d", "--wall-limit"), 129600);
  for (const char* text : {"", "h", "-1h", "0", "0s", "2", "90", "2 hours", "1e99s", "1e999s", "nans", "nan", "inf", "infd", "0x10s"})
    EXPECT_THROW(parse_duration(text, "--wall-limit"), InputError) << text;
}

TEST(SelectionArguments, AskWhichJobsAreMeantAndRefuseWhatIsNoHash) {
  SelectionArguments nothing;
  EXPECT_THROW(selection_of(nothing, "pause"), InputError);
  nothing.all = true;
  EXPECT_TRUE(selection_of(nothing, "pause").is_everything());
  for (const char* word : {"abc", "xyzw", "ABCD", "../../../etc", "' OR 1=1"}) {
    SelectionArguments one;
    one.jobs = {word};
    EXPECT_THROW(selection_of(one, "pause"), InputError) << word;
  }
}

TEST(Range, IsReadFromTwoNumbersOrOne) {
  EXPECT_EQ(parse_range("18:22.5", "--v").hi, 22.5);
  EXPECT_EQ(parse_range("20", "--v").lo, 20);
  EXPECT_EQ(parse_range("+20:2.1e1", "--v").lo, 20);
  EXPECT_EQ(parse_range("0.30000000000000004", "--q").lo, 0.3);
  for (const char* text : {"", ":", "18:", ":22", "a:b", "18:22:30", "22:18", "18x"})
    EXPECT_THROW(parse_range(text, "--v"), InputError) << text;
}

}  // namespace
}  // namespace eerie::cli
