#include "campaign/queries/numbers.hpp"

#include <gtest/gtest.h>

#include "solver/base/error.hpp"

namespace eerie::queries {
namespace {

TEST(ParseDuration, TakesTheUnitsOfPeopleAndNothingElse) {
  EXPECT_EQ(parse_duration("90s", "--wall-limit"), 90);
  EXPECT_EQ(parse_duration("45min", "--wall-limit"), 2700);
  EXPECT_EQ(parse_duration("1.5d", "--wall-limit"), 129600);
  for (const char* text : {"", "h", "-1h", "0", "0s", "2", "90", "2 hours", "1e99s", "1e999s",
                           "nans", "nan", "inf", "infd", "0x10s"})
    EXPECT_THROW(parse_duration(text, "--wall-limit"), InputError) << text;
}

TEST(ParseTimes, TakesNumbersWithCommasAndRefusesWhatIsNoTime) {
  EXPECT_EQ(parse_times("0, 5e3,1e4", "--panels", 3), (std::vector<double>{0, 5000, 10000}));
  EXPECT_TRUE(parse_times("", "--panels", 3).empty());
  for (const char* text : {"soon", "-5", "0,,5", "1 2", "inf", "0,1,2,3"})
    EXPECT_THROW(parse_times(text, "--panels", 3), InputError) << text;
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
}  // namespace eerie::queries
