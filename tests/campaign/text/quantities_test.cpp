#include "campaign/text/quantities.hpp"

#include <gtest/gtest.h>

namespace eerie::text {
namespace {

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

TEST(CountOf, KnowsOneFromSeveral) {
  EXPECT_EQ(count_of(1, "job"), "1 job");
  EXPECT_EQ(count_of(0, "job"), "0 jobs");
}

}  // namespace
}  // namespace eerie::text
