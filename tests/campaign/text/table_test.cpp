#include "campaign/text/table.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "campaign/text/layout.hpp"

namespace eerie::text {
namespace {
using testing::HasSubstr;
using testing::Not;

struct Impact {
  double v = 0;
  std::string outcome;
  std::optional<double> b_over_a;
  bool eer = false;
};

Table impacts(const std::string& outcome = "hit-and-run") {
  const std::vector<Field<Impact>> fields = {
      {both("v_imp_cm_per_s", "v cm/s"), [](const Impact& i) { return i.v; }},
      {both("class", "class"), [](const Impact& i) { return i.outcome; }},
      {both("b_over_a", "b/a", "{:.3f}"), [](const Impact& i) { return or_null(i.b_over_a); }},
      {both("eer", "EER"), [](const Impact& i) { return i.eer; }},
      {data("seed"), [](const Impact&) { return 7; }},
      {shown("remark"), [](const Impact& i) { return i.eer ? "long" : ""; }}};
  return table_of<Impact>(fields, {{20, outcome, 0.24, true}, {22.5, "erosion", {}, false}});
}

std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) widest = std::max(widest, width_of(line));
  return widest;
}

TEST(TableForPrograms, HasTheNamedColumnsWithTheirOwnValues) {
  const nlohmann::json list = records(impacts());
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0], nlohmann::json::parse(R"({"v_imp_cm_per_s": 20.0, "class": "hit-and-run",
                                              "b_over_a": 0.24, "eer": true, "seed": 7})"));
  EXPECT_TRUE(list[1]["b_over_a"].is_null());
  EXPECT_EQ(csv(impacts("a, \"b\"")),
            "v_imp_cm_per_s,class,b_over_a,eer,seed\n"
            "20.0,\"a, \"\"b\"\"\",0.24,1,7\n"
            "22.5,erosion,,0,7\n");
}

TEST(TableForPeople, HasTheColumnsWithAHeader) {
  EXPECT_EQ(aligned(impacts(), 0),
            "v cm/s  class          b/a  EER  remark\n"
            "    20  hit-and-run  0.240  yes  long\n"
            "  22.5  erosion          -\n");
}

TEST(TableForPeople, PutsWhatAllRowsShareAboveWhereThatIsAsked) {
  Table table = impacts();
  table.columns[0].above = table.columns[3].above = true;
  table.columns[0].unit_above = " cm/s";
  table.rows[1][0] = table.rows[0][0];
  EXPECT_THAT(aligned(table, 0), testing::StartsWith("v cm/s 20 cm/s\n\nclass"));
}

TEST(TableForPeople, ShowsControlCharactersOfTextAndDoesNotObeyThem) {
  const std::string text = aligned(impacts("a\x1b[2J\nb"), 0);
  EXPECT_THAT(text, HasSubstr("a\\x1b[2J\\nb"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
}

TEST(TableForPeople, NeverTakesMoreThanTheWidthOfTheTerminal) {
  Table table = impacts("an outcome that somebody described in a good many words");
  for (std::size_t width = 1; width < 100; ++width)
    EXPECT_LE(widest_line(aligned(table, width)), width) << width;
}

TEST(TableForPeople, WrapsWordsBeforeItLeavesColumnsOut) {
  const Table table = impacts("an outcome that somebody described in a good many words");
  EXPECT_THAT(aligned(table, 60), Not(HasSubstr("no room for")));
  EXPECT_THAT(aligned(table, 60), HasSubstr("words"));
}

TEST(TableForPeople, LeavesOutTheMostDispensableColumnAndSaysSo) {
  Table table = impacts();
  table.columns[2].dispensable = 1;
  const std::string text = aligned(table, 36);
  EXPECT_THAT(text, HasSubstr("(no room for: b/a)"));
  EXPECT_THAT(text, HasSubstr("remark"));
  EXPECT_THAT(aligned(impacts(), 36), HasSubstr("(no room for: remark)")) << "of equals the last";
}

TEST(TableInMarkdown, EscapesWhatWouldEndACell) {
  EXPECT_THAT(markdown(impacts("a|b")), HasSubstr("| 20 | a\\|b | 0.240 | yes | long |\n"));
  EXPECT_THAT(markdown(impacts()), HasSubstr("|---|---|---|---|---|\n"));
}

TEST(TableOfRecords, ChoosesColumnsByTheirNames) {
  const Table table = chosen(records(impacts()), {both("class", "class"), both("none", "none")});
  EXPECT_EQ(aligned(table, 0), "class        none\nhit-and-run     -\nerosion         -\n");
}

}  // namespace
}  // namespace eerie::text
