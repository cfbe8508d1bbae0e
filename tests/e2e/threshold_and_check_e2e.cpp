#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "solver/base/constants.hpp"
#include "solver/base/file.hpp"
#include "tests/support/impact_database.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using test::survey_scene;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// The fine grid of the paper with a ridge at 4.9 cm/s, below 24.5 cm/s, and three seeds of the
/// reference impact; then three impacts at 50 deg.
class ThresholdAndCheck : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared = new test::TemporaryFolder;
    db::Connection connection(*shared / "ridge.sqlite", db::Access::write);
    std::vector<std::pair<json, double>> impacts;
    for (int v = 15; v <= 30; ++v)
      for (double theta = 7.5; theta <= 20; theta += 2.5) {
        const double away = v * std::sin(radians(theta)) - 4.9;
        const double shape = v < 24.5 ? std::min(0.24 + 0.2 * away * away, 0.9) : 0.6;
        impacts.emplace_back(survey_scene(1, 40, v, theta, 1), shape);
      }
    for (const int seed : {2, 3}) impacts.emplace_back(survey_scene(1, 40, 20, 15, seed), 0.25);
    for (const int v : {20, 25, 30}) impacts.emplace_back(survey_scene(1, 50, v, 15, 1), 0.5);
    test::add_impacts(connection, impacts);
  }
  static void TearDownTestSuite() { delete shared; }

  Ended eerie(std::vector<std::string> arguments) { return test::eerie(folder.path(), arguments); }
  std::string database() const { return *shared / "ridge.sqlite"; }
  json fact(const json& report, const std::string& name) {
    for (const json& f : report.at("facts"))
      if (f.at("name") == name) return f;
    throw std::runtime_error("no fact " + name);
  }

  static test::TemporaryFolder* shared;
  test::TemporaryFolder folder;
};
test::TemporaryFolder* ThresholdAndCheck::shared = nullptr;

TEST_F(ThresholdAndCheck, FitTheRidgeOfADatabaseAndSayWhereThereIsNone) {
  const Ended ended = eerie({"threshold", "--db", database()});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("q = 1, phi_d = 40 deg, survey (1000 particles per target), 98 "
                                   "runs of 96 impacts"));
  EXPECT_THAT(ended.out, HasSubstr("; paper 5.1, "));
  EXPECT_THAT(ended.out, HasSubstr("above: none at 25"));
  EXPECT_THAT(ended.out, HasSubstr("not enough data: needs impacts that leave at least 4 "));
  const json report = json::parse(eerie({"threshold", "--db", database(), "--json"}).out);
  ASSERT_EQ(report.at("ridges").size(), 2u);
  const json& ridge = report["ridges"][0];
  EXPECT_NEAR(ridge.at("v_sin_theta_cm_per_s"), 4.9, 0.1);
  EXPECT_LT(ridge.at("low_cm_per_s"), ridge.at("high_cm_per_s"));
  EXPECT_EQ(ridge.at("v_imp_cm_per_s").at("high"), 24);
  EXPECT_TRUE(report["ridges"][1].contains("not_enough_data"));
  EXPECT_FALSE(report["ridges"][1].contains("v_sin_theta_cm_per_s"));
}

TEST_F(ThresholdAndCheck, DrawTheFittedCurveAndListAllConstants) {
  Ended ended = eerie({"threshold", "--db", database(), "-o", "new-ridge.svg"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(read_file(folder / "new-ridge.svg"), HasSubstr("fitted: v sin θ"));
  ended = eerie({"threshold", "--db", database(), "-o", "ridge.csv"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const std::string csv = read_file(folder / "ridge.csv");
  EXPECT_THAT(csv, HasSubstr("\n1,40,1000,survey,98,4."));
  EXPECT_THAT(csv, HasSubstr("\n1,50,1000,survey,3,,,,,,,,,,7.4\n"));
}

TEST_F(ThresholdAndCheck, TestTheFactsOfThePaperAndSayWhatToRun) {
  const Ended ended = eerie({"check", "--db", database(), "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json report = json::parse(ended.out);
  EXPECT_EQ(fact(report, "reference-b-over-a").at("verdict"), "agrees");
  EXPECT_EQ(fact(report, "reference-b-over-a").at("runs"), 3);
  EXPECT_EQ(fact(report, "phi40-ridge").at("verdict"), "agrees");
  EXPECT_EQ(fact(report, "phi40-bounds").at("verdict"), "not enough data");
  EXPECT_EQ(fact(report, "phi40-bounds").at("impacts"), 96);
  EXPECT_EQ(fact(report, "phi40-fast").at("verdict"), "disagrees");
  const std::string command = fact(report, "phi30-none").at("to_run");
  EXPECT_EQ(command,
            "eerie run sweeps/table2-phi30.json --db " + database() + " --fidelity survey");
}

TEST_F(ThresholdAndCheck, SuggestSweepsThatExpandToTheMissingRuns) {
  const json report = json::parse(eerie({"check", "--db", database(), "--json"}).out);
  const std::string command = fact(report, "reference-lasts").at("to_run");
  const std::size_t open = command.find('{'), close = command.find('\'', open);
  install_text(folder / "check.json", command.substr(open, close - open));
  std::vector<std::string> arguments = {"expand", "check.json", "--db", "none.sqlite", "--json"};
  for (std::size_t at = command.find("--fidelity"); at < command.size();) {
    const std::size_t end = std::min(command.find(' ', at), command.size());
    arguments.push_back(command.substr(at, end - at));
    at = end + 1;
  }
  const Ended ended = eerie(arguments);
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(json::parse(ended.out).at("jobs"), 6);
}

TEST_F(ThresholdAndCheck, WriteAReportWithMaps) {
  const Ended ended = eerie({"check", "--db", database(), "-o", "report.md"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("checked by `eerie disk`"));
  const std::string report = read_file(folder / "report.md");
  EXPECT_THAT(report, HasSubstr("| reference-b-over-a | q 1, 40 deg, 20 cm/s, 15 deg |"));
  EXPECT_THAT(report, HasSubstr("## What would decide the open ones"));
  EXPECT_THAT(report, HasSubstr("(report-q1-phi40-n1000.svg)"));
  EXPECT_THAT(read_file(folder / "report-q1-phi40-n1000.svg"), HasSubstr("<svg"));
}

TEST_F(ThresholdAndCheck, TellSettingsOfTheSameNameApart) {
  {
    db::Connection connection(folder / "two.sqlite", db::Access::write);
    json scene = survey_scene(1, 40, 20, 15, 1);
    for (const double cfl : {0.5, 0.6}) {
      scene["numerics"]["cfl"] = cfl;
      test::add_impact(connection, scene, 0.25);
    }
  }
  const Ended both = eerie({"threshold", "--db", "two.sqlite"});
  EXPECT_THAT(both.out, HasSubstr("1 runs of 1 impacts, settings 1\n"));
  EXPECT_THAT(both.out, HasSubstr("1 runs of 1 impacts, settings 2\n"));
  const json one =
      json::parse(eerie({"threshold", "--db", "two.sqlite", "--settings", "2", "--json"}).out);
  ASSERT_EQ(one.at("ridges").size(), 1u);
  EXPECT_EQ(one["ridges"][0].at("settings_number"), 2);
}

TEST_F(ThresholdAndCheck, RefuseWhatTheyCannotDoAndSayWhatWouldDo) {
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      {{"check", "--db", database(), "-o", "report.pdf"}, "its name must end in .md"},
      {{"threshold", "--db", database(), "--q", "0.5"}, "holds no result with these parameters"},
      {{"threshold", "--db", database(), "--phi-d", "50", "-o", "a.svg"}, "give FILE.csv"},
      {{"threshold", "--db", database(), "-o", "a.gif"}, "a.gif"},
  };
  for (const auto& [arguments, expected] : cases) {
    const Ended ended = eerie(arguments);
    EXPECT_EQ(ended.code, 2) << expected;
    EXPECT_THAT(ended.err, HasSubstr(expected));
    EXPECT_EQ(ended.out, "") << expected;
  }
  EXPECT_EQ(eerie({"check", "--db", "none.sqlite"}).code, 3);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace eerie
