#include "tests/proof/page.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace eerie::proof {
namespace {

using nlohmann::json;
using testing::AllOf, testing::ElementsAre, testing::HasSubstr, testing::Not;

json check(const std::string& what, double value, double lo, double hi, const std::string& reason) {
  return {{"kind", "check"}, {"what", what}, {"value", value},
          {"lo", lo},        {"hi", hi},     {"passed", value >= lo && value <= hi},
          {"reason", reason}};
}

json note(const std::string& what, double value, const std::string& wish, const std::string& why) {
  return {{"kind", "note"}, {"what", what}, {"value", value}, {"wish", wish}, {"reason", why}};
}

json figure(const std::string& file, const std::string& caption) {
  return {{"kind", "figure"}, {"file", file}, {"caption", caption}};
}

json record(const std::vector<json>& blocks) {
  return {
      {"title", "Run-out"}, {"text", "Columns fall."}, {"passed", true}, {"blocks", json(blocks)}};
}

std::vector<std::string> shown(const std::vector<json>& blocks) {
  std::vector<std::string> names;
  for (const json& line : shown_lines(record(blocks))) names.push_back(line["what"]);
  return names;
}

std::string page_of(const std::vector<json>& blocks) {
  return markdown_page({"validation", "# Proofs", "How."}, {record(blocks)});
}

TEST(ChecksCsv, HasARowForEachCheckAndEachNoteAndForNothingElse) {
  std::vector<json> blocks{figure("a.svg", "A"), note("b/a", 0.5, "above 0.3", "near")};
  for (int k = 0; k < 5; ++k) blocks.push_back(check("speed", k, 0, 10, "theory"));
  blocks.push_back({{"kind", "text"}, {"text", "Said."}});
  const std::string csv = checks_csv({record(blocks), record(blocks)});
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 2 * 6);
}

TEST(ChecksCsv, GivesEntryQuantityValueUnitBoundsAndReason) {
  EXPECT_EQ(checks_csv({record({check("period, h", 10.5, 7, 12, "scatter"),
                                note("drift of L, plain", 0.006, "below 1e-3", "no correction"),
                                check("c* at 0 deg", 8, 1, 3, "published")})}),
            "entry,quantity,measured,unit,allowed_from,allowed_to,wished,holds,reason\n"
            "Run-out,period,10.5,h,7,12,,yes,scatter\n"
            "Run-out,\"drift of L, plain\",0.006,1,,,below 1e-3,noted,no correction\n"
            "Run-out,c* at 0 deg,8,1,1,3,,no,published\n");
}

TEST(ChecksCsv, QuotesWhatHoldsCommasAndQuotationMarks) {
  EXPECT_THAT(checks_csv({record({check("a \"thin\" layer", 1, 0, 2, "here, and there")})}),
              HasSubstr("Run-out,\"a \"\"thin\"\" layer\",1,1,0,2,,yes,\"here, and there\"\n"));
}

TEST(ShownLines, LeaveOutOfThreeAndMoreThatHoldForOneReasonAllButTheNearestToItsBounds) {
  EXPECT_THAT(
      shown({check("middle", 1.0, 0.8, 1.2, "theory"), check("low", 0.85, 0.8, 1.2, "theory"),
             check("high", 1.1, 0.8, 1.2, "theory"), check("other", 1, 0, 2, "symmetry")}),
      ElementsAre("low", "other"));
  EXPECT_THAT(shown({check("one", 1.0, 0.8, 1.2, "theory"), check("two", 1.1, 0.8, 1.2, "theory")}),
              ElementsAre("one", "two"));
}

TEST(ShownLines, TakeALowerBoundOfZeroForThatOfASize) {
  EXPECT_THAT(shown({check("tiny", 1e-6, 0, 1, "drift"), check("large", 0.6, 0, 1, "drift"),
                     check("exact", 0, 0, 0, "drift")}),
              ElementsAre("large"));
}

TEST(ShownLines, NeverLeaveOutWhatIsNotedOrFails) {
  EXPECT_THAT(shown({note("n1", 1, "2", "thin"), note("n2", 1, "2", "thin"),
                     check("holds 1", 1, 0, 2, "thin"), check("fails 1", 3, 0, 2, "thin"),
                     check("holds 2", 1.5, 0, 2, "thin"), check("fails 2", 4, 0, 2, "thin"),
                     check("holds 3", 1, 0, 2, "thin"), note("n3", 1, "2", "thin")}),
              ElementsAre("fails 1", "holds 2", "fails 2", "n1", "n2", "n3"));
}

TEST(ProofPage, SaysHowManyChecksHoldWhereItLeavesSomeOut) {
  std::vector<json> blocks{check("a", 1, 0, 2, "theory"), check("b", 1, 0, 2, "theory")};
  EXPECT_THAT(page_of(blocks), Not(HasSubstr("in the CSV")));
  blocks.push_back(check("c", 1, 0, 2, "theory"));
  EXPECT_THAT(page_of(blocks), HasSubstr("| a | 1 | ≤ 2 |\n\n3 of 3 hold; the rest in the CSV.\n"));
}

TEST(ProofPage, GivesReasonsForWhatIsNotedAndWhatFailsOnly) {
  const std::string page =
      page_of({check("holds", 1, 0.5, 2, "theory"), check("fails", 3, 0.5, 2, "symmetry"),
               note("tip", 1.4, "0.8 to 1.3", "thin"), note("top", 1.5, "0.8 to 1.3", "thin")});
  EXPECT_THAT(page, AllOf(HasSubstr("| holds | 1 | 0.5–2 |\n"), Not(HasSubstr("theory"))));
  EXPECT_THAT(page, HasSubstr("| Run-out | **1 of 2** | 2 |\n"));
  EXPECT_THAT(page, HasSubstr("| fails | 3 | 0.5–2, **not held**: symmetry |\n"));
  EXPECT_THAT(page, HasSubstr("| tip | 1.4 | 0.8–1.3, *noted*: thin |\n"
                              "| top | 1.5 | 0.8–1.3, *noted*: as above |\n"));
}

TEST(ProofPage, GivesACaptionOnceAndTheNumbersOfAFigureBesideIt) {
  const json table = {
      {"kind", "table"},
      {"head", {"a", "dL/L0, measured"}},
      {"rows", json::array({json::array({"1", "1.31"}), json::array({"", "2.67"})})}};
  EXPECT_THAT(page_of({table, figure("column.svg", "Run-out of columns")}),
              AllOf(HasSubstr("![column](figures/validation/column.svg)\n\n*Run-out of columns* "
                              "([numbers](figures/validation/column.csv))\n"),
                    Not(HasSubstr("2.67"))));
  EXPECT_EQ(
      numbers_of(record({table, figure("column.svg", "Run-out of columns")})),
      std::pair(std::string("column.csv"), std::string("a,\"dL/L0, measured\"\n1,1.31\n,2.67\n")));
  EXPECT_THAT(page_of({table}), HasSubstr("| 1 | 1.31 |\n"));
}

}  // namespace
}  // namespace eerie::proof
