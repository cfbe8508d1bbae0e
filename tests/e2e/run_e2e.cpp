#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/base/file.hpp"
#include "tests/campaign/sweeps/malformed_sweeps.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr const char* four_points = R"({"v_imp_cm_per_s": [15, 20], "theta_imp_deg": [10, 15]})";

class Run : public testing::Test {
 protected:
  Ended eerie(const std::vector<std::string>& arguments) {
    return test::eerie(folder.path(), arguments);
  }
  std::set<std::string> files() {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder.path()))
      names.insert(entry.path().filename());
    return names;
  }
  test::TemporaryFolder folder;
};

/// The lines of the table of outcomes.
std::string table_of(const std::string& out) {
  return out.substr(out.find("v cm/s"), out.find("jobs done") - out.find("v cm/s"));
}

TEST_F(Run, EndsWithATableAndAMapAndHasNothingLeftToDoAfterwards) {
  test::write_sweep(folder.path(), 2000, four_points);
  const Ended first = eerie({"run", "sweep.json", "--workers", "2"});
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("4 of 4 jobs done"));
  EXPECT_THAT(first.out, HasSubstr("database: eerie.sqlite"));
  EXPECT_THAT(read_file(folder / "eerie-small-b-over-a.png"), testing::StartsWith("\x89PNG"));
  EXPECT_THAT(read_file(folder / "eerie-small-b-over-a.svg"), HasSubstr("<svg"));

  const Ended second = eerie({"run", "sweep.json"});
  EXPECT_EQ(second.code, 0);
  EXPECT_THAT(second.out, HasSubstr("nothing left to do"));
  EXPECT_EQ(table_of(second.out), table_of(first.out));
}

TEST_F(Run, DrawsIntoTheFilesAskedForAndMakesTheDatabasesFolder) {
  test::write_sweep(folder.path(), 300, R"({"v_imp_cm_per_s": [15, 20]})");
  const Ended ended = eerie({"run", "sweep.json", "--db", "results/a.sqlite", "--map", "map.pdf"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(read_file(folder / "map.pdf"), testing::StartsWith("%PDF"));
  EXPECT_TRUE(fs::exists(folder / "results/a.sqlite"));
  EXPECT_TRUE(fs::exists(folder / "results/a-small-b-over-a.png"));
}

TEST_F(Run, DoesOnlyWhatAnEarlierSweepLeftOut) {
  test::write_sweep(folder.path(), 300, R"({"v_imp_cm_per_s": [15, 20]})");
  ASSERT_EQ(eerie({"run", "sweep.json"}).code, 0);
  test::write_sweep(folder.path(), 300, R"({"v_imp_cm_per_s": [15, 20, 25]})");
  const Ended wider = eerie({"run", "sweep.json"});
  EXPECT_EQ(wider.code, 0);
  EXPECT_THAT(wider.out, HasSubstr("3 jobs, 1 new, 1 to run"));
  EXPECT_EQ(test::job_directories(folder / "eerie.sqlite").size(), 3u);
}

TEST_F(Run, MakesTheBodiesOfAGridOnce) {
  test::write_sweep(folder.path(), 300, four_points);
  ASSERT_EQ(eerie({"run", "sweep.json", "--workers", "1"}).code, 0);
  int bodies = 0, taken = 0;
  for ([[maybe_unused]] const auto& entry :
       fs::directory_iterator(folder / "eerie.sqlite.jobs/bodies"))
    ++bodies;
  for (const fs::path& job : test::job_directories(folder / "eerie.sqlite"))
    if (read_file(job / "log.txt").find("taken at rest") != std::string::npos) ++taken;
  EXPECT_EQ(bodies, 2);
  EXPECT_EQ(taken, 3);
  EXPECT_EQ(eerie({"doctor"}).code, 0);
}

TEST_F(Run, RefusesMalformedSweepsWithoutWritingAnything) {
  int tried = 0;
  for (const test::MalformedSweep& sweep : test::malformed_sweeps()) {
    if (++tried % 12 != 0)
      continue;  // the unit tests have them all; here a tenth goes the whole way
    std::ofstream(folder / "bad.json", std::ios::binary) << sweep.text;
    const Ended ended = eerie({"run", "bad.json", "--db", "new/eerie.sqlite"});
    EXPECT_EQ(ended.code, 2) << sweep.name;
    EXPECT_THAT(ended.err, HasSubstr("bad.json")) << sweep.name;
    EXPECT_THAT(ended.err, HasSubstr(sweep.expected)) << sweep.name;
    EXPECT_EQ(ended.out, "") << sweep.name;
    EXPECT_EQ(files(), std::set<std::string>{"bad.json"}) << sweep.name;
  }
}

TEST_F(Run, RefusesWhatIsWrongOnTheCommandLine) {
  test::write_sweep(folder.path(), 300, four_points);
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      {{}, "needs a command"},
      {{"fly"}, "there is no command \"fly\""},
      {{"plot"}, "did you mean map?"},
      {{"quary"}, "did you mean query?"},
      {{"run"}, "SWEEP"},
      {{"run", "nowhere.json"}, "nowhere.json"},
      {{"run", "sweep.json", "--fast"}, "`eerie run` has no option --fast"},
      {{"run", "sweep.json", "--database", "a"}, "did you mean --db?"},
      {{"run", "sweep.json", "--velocity", "20"}, "--set impact.v_imp_cm_per_s=VALUE"},
      {{"catalogue", "import", "x", "--out=y"}, "did you mean --output?"},
      {{"run", "sweep.json", "--workers", "0"}, "--workers"},
      {{"run", "sweep.json", "--workers", "two"}, "--workers"},
      {{"run", "sweep.json", "--set", "numerics.sead=3"}, "numerics.seed"},
      {{"run", "sweep.json", "--map", "map.gif"}, ".png, .svg or .pdf"},
      {{"run", "sweep.json", "--map", "m.png", "--set", "numerics.seed=-1"}, "at least 0"},
      {{"query", "--format", "xml"}, "--format"},
      {{"solve", "sweep.json", "--out", "o"},
       "sweep.json: is a sweep of impacts and not the scene of one impact; `eerie run sweep.json`"},
  };
  for (const auto& [arguments, expected] : cases) {
    const Ended ended = eerie(arguments);
    EXPECT_EQ(ended.code, 2) << expected;
    EXPECT_THAT(ended.err + ended.out, HasSubstr(expected));
  }
  EXPECT_EQ(files(), std::set<std::string>{"sweep.json"});
}

TEST_F(Run, SaysThatTheEnvironmentIsAtFaultWhereItIs) {
  test::write_sweep(folder.path(), 300, four_points);
  EXPECT_EQ(eerie({"status"}).code, 3);
  EXPECT_THAT(eerie({"query", "--db", "none.sqlite"}).err,
              HasSubstr("none.sqlite: there is no such file"));
  std::ofstream(folder / "notes.txt") << std::string(1000, 'x');
  const Ended ended = eerie({"run", "sweep.json", "--db", "notes.txt"});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("not an SQLite database"));
}

TEST_F(Run, HelpsWithExamplesForEveryCommand) {
  for (const char* command : {"run", "expand", "solve", "analyse", "status", "query", "map"}) {
    const Ended help = eerie({command, "--help"});
    EXPECT_EQ(help.code, 0);
    EXPECT_THAT(help.out, HasSubstr(std::string("  eerie ") + command)) << command;
  }
  EXPECT_EQ(eerie({"--help"}).code, 0);
  EXPECT_THAT(eerie({"--version"}).out, HasSubstr("eerie 1."));
}

TEST_F(Run, SpeaksJsonEverywhere) {
  test::write_sweep(folder.path(), 300, R"({"v_imp_cm_per_s": [15, 20]})");
  const auto parsed = [&](std::vector<std::string> arguments) {
    arguments.push_back("--json");
    const Ended ended = eerie(arguments);
    EXPECT_EQ(ended.code, 0) << arguments[0] << ": " << ended.err;
    return json::parse(ended.out);
  };
  EXPECT_EQ(parsed({"expand", "sweep.json", "--list"}).at("list").size(), 2u);
  EXPECT_FALSE(fs::exists(folder / "eerie.sqlite")) << "expand is a dry run";
  EXPECT_EQ(parsed({"run", "sweep.json"}).at("results").size(), 2u);
  EXPECT_EQ(parsed({"expand", "sweep.json"}).at("new"), 0);
  EXPECT_EQ(parsed({"status"}).at("sweeps").at(0).at("jobs").at("done"), 2);
  EXPECT_EQ(parsed({"query", "--v", "14:16"}).at(0).at("v_imp_cm_per_s"), 15);
  EXPECT_EQ(parsed({"map", "-o", "m.svg"}).at("pictures").at(0), "m.svg");
  const fs::path job = test::job_directories(folder / "eerie.sqlite").at(0);
  EXPECT_TRUE(parsed({"analyse", (job / "final.hdf5").string()}).contains("outcome"));
  std::ofstream(folder / "scene.json")
      << R"({"numerics": {"particles_per_target": 100}, "end": {"time_s": 300}})";
  const json solved = parsed({"solve", "scene.json", "--out", "impact", "--threads", "1"});
  EXPECT_TRUE(solved.at("finished").get<bool>());
  EXPECT_GT(solved.at("run").at("particle_steps_per_core_second").get<double>(), 0);
}

TEST_F(Run, StudiesConvergenceAndHasNothingLeftToDoAfterwards) {
  install_text(folder / "study.json", R"({
    "name": "tiny", "schemes": ["dual", "shear-free"],
    "scene": {"end": {"time_s": 300}},
    "cases": [{"name": "A", "scene": {}, "published": {"b_over_a": 0.24}}],
    "ladder": [{"particles_per_target": 200, "seeds": 2}, {"particles_per_target": 300, "seeds": 1}]})");
  const std::vector<std::string> command = {"converge", "study.json", "--workers",
                                            "2",        "-o",         "out"};
  const Ended nothing_there = eerie({"converge", "study.json", "--draw-only", "-o", "out"});
  EXPECT_EQ(nothing_there.code, 3);
  EXPECT_THAT(nothing_there.err, HasSubstr("eerie.sqlite"));
  const Ended all = eerie(command);
  ASSERT_EQ(all.code, 0) << all.err;
  EXPECT_THAT(all.out, HasSubstr("6 results"));
  EXPECT_THAT(read_file(folder / "out/A.svg"), HasSubstr("shear-free"));
  const std::string table = read_file(folder / "out/convergence.csv");
  EXPECT_THAT(table, HasSubstr("dual,A,200,2,"));
  EXPECT_THAT(table, HasSubstr("shear-free,A,300,1,"));
  const Ended again = eerie(command);
  EXPECT_THAT(again.out, HasSubstr("6 runs within the budget, 0 to run"));
  EXPECT_EQ(read_file(folder / "out/convergence.csv"), table);

  // Elsewhere, with nothing but the table of the runs.
  const Ended known = eerie({"converge", "study.json", "--known", "out/runs.csv", "--db",
                             "elsewhere.sqlite", "-o", "known"});
  ASSERT_EQ(known.code, 0) << known.err;
  EXPECT_EQ(read_file(folder / "known/runs.csv"), read_file(folder / "out/runs.csv"));
  const Ended drawn = eerie({"converge", "study.json", "--known", "out/runs.csv", "--draw-only",
                             "--db", "nowhere.sqlite", "-o", "drawn"});
  ASSERT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_THAT(read_file(folder / "drawn/A.svg"), HasSubstr("shear-free"));
  EXPECT_FALSE(fs::exists(folder / "nowhere.sqlite"));
}

TEST_F(Run, RunsOfAStudyOnlyWhatIsNotKnown) {
  const auto study = [&](int seeds) {
    install_text(folder / "study.json", fmt::format(R"({{
      "name": "tiny", "schemes": ["dual"], "scene": {{"end": {{"time_s": 300}}}},
      "cases": [{{"name": "A", "scene": {{}}}}],
      "ladder": [{{"particles_per_target": 200, "seeds": {}}}]}})",
                                                    seeds));
  };
  study(2);
  ASSERT_EQ(eerie({"converge", "study.json", "-o", "out"}).code, 0);
  study(3);
  const Ended more = eerie({"converge", "study.json", "--known", "out/runs.csv", "--db",
                            "elsewhere.sqlite", "-o", "more"});
  ASSERT_EQ(more.code, 0) << more.err;
  EXPECT_THAT(more.out, HasSubstr("3 runs within the budget, 2 known, 1 to run"));
  EXPECT_THAT(more.out, HasSubstr("3 results"));

  // Tables of several machines, in either order.
  for (const auto& [first, second] :
       {std::pair("out/runs.csv", "more/runs.csv"), std::pair("more/runs.csv", "out/runs.csv")}) {
    const Ended drawn = eerie({"converge", "study.json", "--known", first, "--known", second,
                               "--draw-only", "--db", "nowhere.sqlite", "-o", "drawn"});
    ASSERT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_THAT(drawn.out, HasSubstr("3 results"));
  }
}

TEST_F(Run, AnswersQueriesAsTableAndCsvAndSaysWhenNothingMatches) {
  test::write_sweep(folder.path(), 300, four_points);
  ASSERT_EQ(eerie({"run", "sweep.json"}).code, 0);
  const Ended table =
      eerie({"query", "--v", "20", "--theta", "10:12", "--q", "1", "--phi-d", "40"});
  EXPECT_THAT(table.out, HasSubstr("M_lr/M"));
  const Ended csv = eerie({"query", "--format", "csv", "--theta", "15"});
  EXPECT_EQ(std::count(csv.out.begin(), csv.out.end(), '\n'), 3);
  const Ended nothing = eerie({"query", "--v", "100:200"});
  EXPECT_EQ(nothing.code, 0);
  EXPECT_THAT(nothing.err, HasSubstr("no result in eerie.sqlite matches"));
  EXPECT_EQ(eerie({"query", "--class", "explosion"}).code, 2);
  EXPECT_EQ(eerie({"map", "--q", "0.7", "-o", "m.png"}).code, 2);
}

TEST_F(Run, SolvesOneImpactInPieces) {
  std::ofstream(folder / "scene.json")
      << R"({"numerics": {"particles_per_target": 100}, "end": {"time_s": 1000}})";
  const Ended piece =
      eerie({"solve", "scene.json", "--out", "impact", "--max-steps", "50", "--threads", "1"});
  EXPECT_EQ(piece.code, 0) << piece.err;
  EXPECT_THAT(piece.out, HasSubstr("particle-steps per second and core"));
  EXPECT_THAT(piece.out, HasSubstr("gravity"));
  EXPECT_FALSE(fs::exists(folder / "impact/result.json"));
  EXPECT_EQ(eerie({"solve", "scene.json", "--out", "impact", "--threads", "1"}).code, 0);
  ASSERT_EQ(eerie({"solve", "scene.json", "--out", "whole", "--threads", "1"}).code, 0);
  const json pieces = json::parse(read_file(folder / "impact/result.json"));
  const json whole = json::parse(read_file(folder / "whole/result.json"));
  EXPECT_EQ(pieces.at("analysis"), whole.at("analysis"));
}

}  // namespace
}  // namespace eerie
