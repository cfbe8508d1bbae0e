#include "campaign/results/view_tables.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace eerie::results {
namespace {
using db::Cell;
using testing::HasSubstr;

/// Two remnants: an EER, and one without a spin and in no group.
db::ViewRows two_remnants() {
  db::ViewRows rows{db::View::remnants,
                    {{"q", "REAL"},
                     {"v_imp_cm_per_s", "REAL"},
                     {"eer", "INTEGER"},
                     {"spin_period_h", "REAL"},
                     {"bound_group", "INTEGER"},
                     {"tilt_deg", "REAL"},
                     {"note", "TEXT"}},
                    {}};
  rows.rows = {
      {1.0, 20.0, std::int64_t{1}, 9.36, std::int64_t{1}, 30.0, "1, 2 and \"3\""},
      {1.0, 25.5, std::int64_t{0}, Cell(), Cell(), -40.0, "line\r\n"},
  };
  return rows;
}

std::string csv(const db::ViewRows& rows) { return text::csv(plain_table(rows)); }
nlohmann::json records(const db::ViewRows& rows) { return text::records(plain_table(rows)); }
std::string for_people(const text::Table& table) { return text::aligned(table, 0); }

TEST(ViewCsv, HasOneFieldPerColumnAndQuotesWhatNeedsIt) {
  EXPECT_EQ(csv(two_remnants()),
            "q,v_imp_cm_per_s,eer,spin_period_h,bound_group,tilt_deg,note\n"
            "1.0,20.0,1,9.36,1,30.0,\"1, 2 and \"\"3\"\"\"\n"
            "1.0,25.5,0,,,-40.0,\"line\r\n\"\n");
}

TEST(ViewRecords, AreAListWithFlagsAndNulls) {
  const nlohmann::json list = records(two_remnants());
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0]["eer"], true);
  EXPECT_EQ(list[0]["v_imp_cm_per_s"], 20.0);
  EXPECT_TRUE(list[1]["spin_period_h"].is_null());
  db::ViewRows none = two_remnants();
  none.rows.clear();
  EXPECT_EQ(records(none), nlohmann::json::array());
}

TEST(ViewDescription, GivesUnitAndMeaningOfEveryColumnAlsoOfUnknownOnes) {
  const nlohmann::json whole = described(two_remnants());
  EXPECT_EQ(whole["name"], "remnants");
  EXPECT_EQ(whole["data"], records(two_remnants()));
  const nlohmann::json& fields = whole["schema"]["fields"];
  ASSERT_EQ(fields.size(), 7u);
  EXPECT_EQ(fields[1]["unit"], "cm/s");
  EXPECT_THAT(fields[1]["description"].get<std::string>(), HasSubstr("speed"));
  EXPECT_EQ(fields[2]["type"], "boolean");
  EXPECT_EQ(fields[4]["type"], "number") << "an integer with gaps";
  EXPECT_EQ(fields[5]["unit"], "deg") << "by its name: the table does not know it";
  EXPECT_EQ(fields[6]["type"], "string");
}

TEST(ShortTable, PutsWhatAllRowsShareAbove) {
  const std::string text = for_people(short_table(two_remnants()));
  EXPECT_THAT(text, testing::StartsWith("q 1\n\nv cm/s"));
  EXPECT_THAT(text, HasSubstr("25.5"));
  EXPECT_THAT(text, testing::Not(HasSubstr("tilt")));
  EXPECT_THAT(for_people(plain_table(two_remnants())), HasSubstr("tilt_deg"));
}

TEST(ShortTable, HasEveryColumnForPrograms) {
  EXPECT_EQ(text::csv(short_table(two_remnants())), csv(two_remnants()));
  EXPECT_EQ(text::records(short_table(two_remnants())), records(two_remnants()));
}

}  // namespace
}  // namespace eerie::results
