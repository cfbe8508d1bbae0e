#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "campaign/job_folder/history.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
namespace fs = std::filesystem;

class Fidelity : public testing::Test {
 protected:
  Ended eerie(const std::vector<std::string>& arguments) {
    return test::eerie(folder.path(), arguments);
  }
  test::TemporaryFolder folder;
};

TEST_F(Fidelity, RunEndsOnceTheImpactHasSettledAndSaysSo) {
  install_text(folder / "sweep.json", R"({
    "name": "slow",
    "scene": {"numerics": {"particles_per_target": 100}, "impact": {"theta_imp_deg": 5},
              "end": {"time_s": 60000, "settled": {"window_s": 2000, "shape": 0.01}}},
    "grid": {"v_imp_cm_per_s": [8]}})");
  const Ended run = eerie({"run", "sweep.json", "--workers", "1"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json row = json::parse(eerie({"query", "--json"}).out).at(0);
  EXPECT_EQ(row.at("end_reason"), "settled");
  EXPECT_EQ(row.at("class"), "perfect-merging");
  const double ended = row.at("ended_at_s");
  EXPECT_GT(ended, 2000);
  EXPECT_LT(ended, 30000);
  const fs::path job = test::job_directories(folder / "eerie.sqlite").at(0);
  const job_folder::RowLog<ending::RemnantLook> looks(job / "remnants.csv");
  ASSERT_FALSE(looks.rows().empty());
  EXPECT_EQ(looks.rows().back().time_s, ended);
  EXPECT_EQ(looks.rows().back().b_over_a, row.at("b_over_a"));
}

TEST_F(Fidelity, ByNameIsNotedWithTheResults) {
  install_text(folder / "sweep.json", R"({"name": "one", "grid": {"v_imp_cm_per_s": [20]}})");
  const Ended unknown = eerie({"run", "sweep.json", "--fidelity", "best"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(
      unknown.err,
      HasSubstr("--fidelity best: must be one of sketch, survey, standard, fine, paper, auto"));
  const Ended listed = eerie({"expand", "sweep.json", "--fidelity", "sketch", "--list"});
  EXPECT_THAT(listed.out, HasSubstr(" 400 "));
  const Ended alone = eerie({"run", "sweep.json", "--confidence", "0.8"});
  EXPECT_EQ(alone.code, 2);
  EXPECT_THAT(alone.err, HasSubstr("--confidence needs --fidelity auto"));
}

TEST_F(Fidelity, SaysWhichFieldsOfTheFileItReplacesInEveryCommandThatTakesOne) {
  install_text(folder / "scene.json", R"({"numerics": {"particles_per_target": 300}})");
  install_text(folder / "sweep.json", R"({
    "name": "own", "scene": {"numerics": {"particles_per_target": 300}},
    "grid": {"v_imp_cm_per_s": [20]}})");
  const std::string told =
      "numerics.particles_per_target = 300 gives way to --fidelity sketch, which has 400; "
      "--set numerics.particles_per_target=300 keeps it";
  for (std::vector<std::string> command : std::vector<std::vector<std::string>>{
           {"expand", "sweep.json"},
           {"submit", "sweep.json"},
           {"run", "sweep.json", "--set", "end.time_s=20", "--set", "end.settled.window_s=20",
            "--workers", "1", "--db", "run.sqlite"},
           {"solve", "scene.json", "--out", "impact", "--max-steps", "1", "--threads", "1"}}) {
    const std::string file = command[1];
    command.insert(command.end(), {"--fidelity", "sketch"});
    EXPECT_THAT(eerie(command).err, HasSubstr("warning: " + file + ": " + told)) << command[0];
  }
  const json expanded =
      json::parse(eerie({"expand", "sweep.json", "--fidelity", "sketch", "--json"}).out);
  EXPECT_EQ(expanded.at("warnings").at(0), "sweep.json: " + told);
  EXPECT_THAT(eerie({"expand", "sweep.json", "--fidelity", "sketch", "--set",
                     "numerics.particles_per_target=300"})
                  .err,
              Not(HasSubstr("gives way")));
}

TEST_F(Fidelity, AutoRunsInRoundsUntilItIsSureAndHasNothingLeftToDoAfterwards) {
  install_text(folder / "sweep.json", R"({"name": "small", "grid": {"v_imp_cm_per_s": [15, 20]}})");
  // Both fidelities cut down to a second: what is tested is the way through them.
  const std::vector<std::string> command = {"run",          "sweep.json",
                                            "--fidelity",   "auto",
                                            "--set",        "end.time_s=200",
                                            "--set",        "numerics.particles_per_target=200",
                                            "--set",        "output.history_interval_s=100",
                                            "--workers",    "2",
                                            "--most-seeds", "4"};
  const Ended first = eerie(command);
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("round 1: 2 of 2 impacts in doubt; wanted: 4 sketch"));
  EXPECT_THAT(first.out, HasSubstr("x 2"));
  EXPECT_THAT(read_file(folder / "eerie-small-auto.csv"), HasSubstr("1,40,15,15,"));
  EXPECT_THAT(read_file(folder / "eerie-small-auto.svg"), HasSubstr("sketch, "));
  const std::string table = read_file(folder / "eerie-small-auto.csv");
  const Ended again = eerie(command);
  EXPECT_EQ(again.code, 0);
  EXPECT_THAT(again.out, Not(HasSubstr("round")));
  EXPECT_EQ(read_file(folder / "eerie-small-auto.csv"), table);
}

TEST_F(Fidelity, AutoKeepsToItsBudget) {
  install_text(folder / "sweep.json", R"({"name": "small", "grid": {"v_imp_cm_per_s": [15, 20]}})");
  const Ended ended = eerie({"run", "sweep.json", "--fidelity", "auto", "--budget", "0.0001"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("2 impacts, 2 in doubt; 0.00 core-hours"));
}

TEST_F(Fidelity, IsChartedAgainstItsCost) {
  install_text(folder / "study.json", R"({
    "name": "tiny", "scene": {"end": {"time_s": 300}, "numerics": {"particles_per_target": 200}},
    "seeds": 2, "cases": [{"name": "A", "scene": {}}],
    "knobs": [{"name": "cfl", "settings": [{"label": "0.3", "set": {"numerics.cfl": 0.3}}]}],
    "reference": {"label": "finer", "seeds": 1, "set": {"numerics.particles_per_target": 400}}})");
  const std::vector<std::string> command = {"chart", "study.json", "--workers", "2", "-o", "c.svg"};
  const Ended first = eerie(command);
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("5 results"));
  EXPECT_THAT(read_file(folder / "c.svg"), HasSubstr("frontier"));
  const std::string table = read_file(folder / "c.csv");
  EXPECT_THAT(table, HasSubstr("\"cfl\",\"0.3\",\"A\",2,"));
  EXPECT_THAT(table, HasSubstr("\"reference\",\"finer\",\"A\",1,"));
  EXPECT_THAT(read_file(folder / "c-runs.csv"), HasSubstr("\"default\",\"\",A,1,"));
  EXPECT_THAT(read_file(folder / "c-cases.csv"), HasSubstr("\"cfl\",\"0.3\",A,2,"));
  EXPECT_THAT(read_file(folder / "c-cases.svg"), HasSubstr("finer"));
  EXPECT_THAT(eerie(command).out, HasSubstr("5 runs within the budget, 0 to run"));
}

}  // namespace
}  // namespace eerie
