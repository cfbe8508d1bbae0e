#include <gmock/gmock.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "solver/base/file.hpp"
#include "tests/support/impact_database.hpp"
#include "tests/support/markdown.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// A database of six surveys, b/a = 0.25 to 0.875, as other programs meet it.
class Exchange : public testing::Test {
 protected:
  Exchange() {
    db::Connection connection(folder / "campaign.sqlite", db::Access::write);
    std::vector<std::pair<json, double>> impacts;
    for (int k = 0; k < 6; ++k)
      impacts.emplace_back(test::survey_scene(k < 3 ? 1 : 0.3, 40, 15.3 + k, 12.5, 1 + k % 2),
                           0.25 + 0.125 * k);
    test::add_impacts(connection, impacts);
  }
  Ended eerie(std::vector<std::string> arguments) { return test::eerie(folder.path(), arguments); }
  Ended ask(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--db", "campaign.sqlite"});
    return eerie(arguments);
  }
  /// Exit code of a script that Debian's Python runs in the folder.
  int python(const std::string& script) {
    install_text(folder / "script.py", script);
    return std::system(
        ("cd " + folder.path().string() + " && /usr/bin/python3 script.py > python.out 2>&1")
            .c_str());
  }
  test::TemporaryFolder folder;
};

TEST_F(Exchange, FilesOfEveryViewAreWhatTheirNameSays) {
  for (const char* view : {"results", "remnants", "maps"}) {
    const std::string csv = std::string(view) + ".csv", whole = std::string(view) + ".json";
    EXPECT_EQ(ask({"query", "--of", view, "-o", csv}).out, csv + "\n");
    const std::string text = read_file(folder.path() / csv);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 7) << view;
    EXPECT_EQ(ask({"query", "--of", view, "-o", whole}).code, 0);
    EXPECT_EQ(json::parse(read_file(folder.path() / whole)),
              json::parse(ask({"query", "--of", view, "--json"}).out));
    const json described = json::parse(ask({"query", "--of", view, "--format", "json-table"}).out);
    EXPECT_EQ(described.at("data").size(), 6u);
    EXPECT_EQ(described.at("name"), view);
  }
}

TEST_F(Exchange, QueriesSortLimitAndChooseColumns) {
  const Ended ended = ask({"query", "--of", "remnants", "--columns", "v_imp_cm_per_s,b_over_a",
                           "--sort", "-b_over_a", "--limit", "2", "--format", "csv"});
  EXPECT_EQ(ended.out, "v_imp_cm_per_s,b_over_a\n20.3,0.875\n19.3,0.75\n");
  const Ended none = ask({"query", "--of", "maps", "--where", "p_eer=0.1:0.2"});
  EXPECT_EQ(none.code, 0);
  EXPECT_EQ(none.out, "");
  EXPECT_THAT(none.err, HasSubstr("no point in campaign.sqlite matches"));
}

TEST_F(Exchange, QueriesThatCannotBeSayWhyAndWriteNothing) {
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      {{"query", "--columns", "b_ovr_a", "-o", "x.csv"}, "the closest are b_over_a"},
      {{"query", "--sort", "vimp", "-o", "x.csv"}, "v_imp_cm_per_s"},
      {{"query", "--where", "b_over_a", "-o", "x.csv"}, "COLUMN=LO:HI"},
      {{"query", "--of", "jobs"}, "--of"},
      {{"query", "-o", "x.parquet"}, "call it .csv, .json or .txt"},
      {{"sizes", "-o", "x.gif"}, ".png, .svg or .pdf"},
      {{"sizes", "--v", "90"}, "no result matches"},
  };
  for (const auto& [arguments, expected] : cases) {
    const Ended ended = ask(arguments);
    EXPECT_EQ(ended.code, 2) << expected;
    EXPECT_THAT(ended.err + ended.out, HasSubstr(expected));
  }
  EXPECT_FALSE(fs::exists(folder / "x.csv"));
}

TEST_F(Exchange, PythonReadsTheCsvAsItIs) {
  ASSERT_EQ(ask({"query", "--of", "remnants", "-o", "remnants.csv"}).code, 0);
  EXPECT_EQ(python(R"(
import csv, sqlite3
rows = list(csv.DictReader(open("remnants.csv", newline="")))
sql = sqlite3.connect("campaign.sqlite")
sql.row_factory = sqlite3.Row
wanted = sql.execute("SELECT * FROM remnants ORDER BY q, v_imp_cm_per_s").fetchall()
assert len(rows) == len(wanted) == 6
for row, one in zip(rows, wanted):
    assert list(row) == one.keys()
    for name in one.keys():
        if one[name] is None:
            assert row[name] == "", name
        else:
            assert type(one[name])(row[name]) == one[name], name
)"),
            0)
      << read_file(folder / "python.out");
}

TEST_F(Exchange, TheDocumentedLinesOfPandasRun) {
  ASSERT_EQ(ask({"query", "--of", "remnants", "-o", "remnants.csv"}).code, 0);
  ASSERT_EQ(ask({"query", "--format", "json-table", "-o", "table.json"}).code, 0);
  const std::string page = read_file(test::source_folder() / "docs/how-to/pandas.md");
  EXPECT_EQ(python(test::code_of(page, "python") +
                   "assert len(remnants) == 6\n"
                   "import os; assert os.path.getsize('map.png') > 1000\n"
                   "assert len(pandas.read_json('table.json', orient='table')) == 6\n"),
            0)
      << read_file(folder / "python.out");
  EXPECT_THAT(read_file(folder / "python.out"), HasSubstr("perfect-merging"));
}

TEST_F(Exchange, ACatalogueGoesOutAndComesBackAsTheSameJobs) {
  const Ended out = ask({"catalogue", "export", "-o", "ours.csv"});
  EXPECT_THAT(out.out, HasSubstr("ours.csv: 6 impacts")) << out.err;
  ASSERT_EQ(eerie({"catalogue", "import", "ours.csv"}).code, 0);
  const json again = json::parse(ask({"expand", "ours.json", "--json"}).out);
  EXPECT_EQ(again.at("jobs"), 6);
  EXPECT_EQ(again.at("new"), 0);
  const Ended beside = ask({"catalogue", "compare", "ours.csv", "-o", "beside.csv"});
  EXPECT_THAT(beside.out, HasSubstr("the class is the same in 6 of 6")) << beside.err;
  EXPECT_THAT(beside.out, HasSubstr("b/a differs by 0.000 (root mean square of 6)"));
  EXPECT_THAT(read_file(folder / "beside.csv"), testing::StartsWith("run_id,line,v_imp_cm_per_s"));
}

TEST_F(Exchange, ABadCatalogueMakesNoSweep) {
  install_text(folder / "bad.csv", "v_imp_m_per_s,theta_imp_deg,m_target_kg,q\n0.2,95,1e9,1\n");
  const Ended ended = eerie({"catalogue", "import", "bad.csv"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("bad.csv, line 2, theta_imp_deg = 95"));
  EXPECT_FALSE(fs::exists(folder / "bad.json"));
}

TEST_F(Exchange, SizesAreSaidDrawnAndWritten) {
  const Ended ended = ask({"sizes", "-o", "s.svg", "-o", "s.csv"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("6 remnants of at least 100 particles"));
  EXPECT_THAT(read_file(folder / "s.svg"), HasSubstr("100 particles"));
  EXPECT_THAT(read_file(folder / "s.csv"), HasSubstr("survey,1000,6,0.95,1,"));
  const json one = json::parse(ask({"sizes", "--where", "job=1", "--json"}).out);
  EXPECT_EQ(one.at("distributions").at(0).at("impacts"), 1);
}

}  // namespace
}  // namespace eerie
