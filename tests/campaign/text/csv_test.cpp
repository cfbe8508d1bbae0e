#include "campaign/text/csv.hpp"

#include <gmock/gmock.h>

#include "campaign/text/csv_table.hpp"
#include "solver/base/error.hpp"

namespace eerie::text {
namespace {

TEST(CsvField, IsQuotedOnlyWhereItMustBe) {
  EXPECT_EQ(csv_field("survey"), "survey");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("a \"b\""), "\"a \"\"b\"\"\"");
  EXPECT_EQ(csv_field("#7"), "\"#7\"");
}

TEST(CsvField, NoSpreadsheetTakesFreeTextForAFormula) {
  EXPECT_EQ(csv_field("=1+1"), "\"'=1+1\"");
  EXPECT_EQ(csv_field("@SUM(A1)"), "\"'@SUM(A1)\"");
  EXPECT_EQ(csv_field("+cmd|' /C calc'!A0"), "\"'+cmd|' /C calc'!A0\"");
  EXPECT_EQ(csv_field("-2+3+cmd"), "\"'-2+3+cmd\"");
  EXPECT_EQ(csv_quoted("=HYPERLINK(\"x\")"), "\"'=HYPERLINK(\"\"x\"\")\"");
  EXPECT_EQ(csv_field("\t=1"), "\"'\t=1\"");
}

TEST(CsvField, NumbersStayNumbers) {
  for (const char* number : {"-5", "+0.3", "-1e-3", "-.5", "7"})
    EXPECT_EQ(csv_field(number), number);
  for (const char* text : {"-", "+", "-nan", "-inf", "-0x10", "-5-3"})
    EXPECT_EQ(csv_field(text), std::string("\"'") + text + "\"");
}

TEST(ParseCsv, ReadsWhatCsvFieldWroteAsItWas) {
  for (const std::string text : {"=1+1", "-5", "#7", "a,\"b\"", "'quoted'", "@x", "it's"}) {
    const CsvTable table = parse_csv("id,v\n" + csv_field(text) + ",20\n", "t.csv");
    ASSERT_EQ(table.rows.size(), 1u) << text;
    EXPECT_EQ(table.rows[0].fields[0], text);
  }
}

TEST(ParseCsv, KeepsRowsWhoseFirstFieldBeginsWithAHash) {
  const CsvTable table = parse_csv(
      "# made by hand, with care\nid,v\n#7,20\n#8,22\n# a remark of one field\n  #9 ,24\n",
      "t.csv");
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[0].fields[0], "#7");
  EXPECT_EQ(table.rows[2].fields[0], "#9");
  try {
    parse_csv("id,v\n#7,20,5\n", "t.csv");
    FAIL() << "a line was dropped";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("comments above the header"));
  }
}

}  // namespace
}  // namespace eerie::text
