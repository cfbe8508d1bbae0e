#include <gmock/gmock.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "solver/base/file.hpp"
#include "solver/base/text/shell_word.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class FirstMinutes : public testing::Test {
 protected:
  Ended eerie(const std::vector<std::string>& arguments) {
    return test::eerie(folder.path(), arguments);
  }
  /// What a shell in the folder makes of a line that someone pastes; its exit code.
  int paste(const std::string& line) {
    const std::string script = "cd " + shell_word(folder.path().string()) +
                               " && PATH=" + shell_word(test::program().parent_path().string()) +
                               ":$PATH && " + line + " > pasted.txt 2>&1";
    return WEXITSTATUS(std::system(script.c_str()));
  }
  std::string pasted() { return read_file(folder / "pasted.txt"); }
  /// A sweep whose jobs take a second each, in a folder and a database whose names need quotes.
  void write_small_sweep(const std::string& grid) {
    install_text(folder / "my sweep.json",
                 R"({"name": "small", "scene": {"numerics": {"particles_per_target": 100,
                     "rigid_flight": false}, "end": {"time_s": 300}}, "grid": )" +
                     grid + "}");
  }

  test::TemporaryFolder folder;
  const std::vector<std::string> run = {
      "run", "my sweep.json", "--db", "my runs.sqlite", "--workers", "1"};
};

TEST_F(FirstMinutes, BeginWithFilesThatTheNextCommandsTake) {
  const Ended begun = eerie({"init", "my impacts", "--json"});
  ASSERT_EQ(begun.code, 0) << begun.err;
  const json told = json::parse(begun.out);
  EXPECT_EQ(told.at("files").size(), 4u);
  ASSERT_EQ(told.at("next").size(), 3u);
  ASSERT_EQ(paste(told.at("next").at(0)), 0) << pasted();
  EXPECT_THAT(pasted(), HasSubstr("impacts: 9 jobs, 9 of them new"));
  // The others at a hundredth of their cost: that they are taken is tested.
  const std::string few = " --set numerics.particles_per_target=100 --set end.time_s=100";
  ASSERT_EQ(paste(told.at("next").at(1).get<std::string>() + few), 0) << pasted();
  EXPECT_THAT(pasted(), HasSubstr("9 of 9 jobs done"));
  ASSERT_EQ(paste(told.at("next").at(2).get<std::string>() + few + " --max-steps 3"), 0)
      << pasted();
}

TEST_F(FirstMinutes, OverwriteNothing) {
  install_text(folder / "scene.json", "mine");
  const Ended refused = eerie({"init"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("scene.json: is there already, and is not overwritten"));
  EXPECT_EQ(read_file(folder / "scene.json"), "mine");
  EXPECT_FALSE(fs::exists(folder / "impacts.json"));
  fs::create_symlink("nowhere", folder / "sweep.schema.json");
  fs::remove(folder / "scene.json");
  EXPECT_EQ(eerie({"init"}).code, 2);
  fs::remove(folder / "sweep.schema.json");
  EXPECT_EQ(eerie({"init"}).code, 0);
  EXPECT_EQ(eerie({"init"}).code, 2);
}

TEST_F(FirstMinutes, HaveHelpOfACommandAsItsOwnOptionGivesIt) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"run"}, {"catalogue", "import"}, {"init"}}) {
    std::vector<std::string> asked = {"help"}, option = words;
    asked.insert(asked.end(), words.begin(), words.end());
    option.push_back("--help");
    EXPECT_EQ(eerie(asked).out, eerie(option).out) << words[0];
  }
  EXPECT_EQ(eerie({"help"}).out, eerie({"--help"}).out);
  const Ended wrong = eerie({"help", "plot"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("did you mean map?"));
}

TEST_F(FirstMinutes, TellAFileOfAnotherKindByTheCommandThatTakesIt) {
  install_text(folder / "my scene.json", R"({"impact": {"q": 1}})");
  for (const char* command : {"run", "expand", "submit"}) {
    const Ended ended = eerie({command, "my scene.json"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.err, HasSubstr("`eerie solve 'my scene.json' --out impact` takes it"));
  }
  EXPECT_EQ(paste("eerie solve 'my scene.json' --out impact --max-steps 1"), 0) << pasted();
}

TEST_F(FirstMinutes, EndWithCommandsThatCanBePastedAsTheyStand) {
  write_small_sweep(R"({"v_imp_cm_per_s": [15, 20], "theta_imp_deg": [10, 15]})");
  std::vector<std::string> command = run;
  command.push_back("--json");
  const Ended ended = eerie(command);
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json next = json::parse(ended.out).at("next");
  std::vector<std::string> commands;
  for (const json& step : next) commands.push_back(step.at("command"));
  EXPECT_THAT(commands, Contains(HasSubstr("eerie show ")));
  EXPECT_THAT(commands, Contains(HasSubstr("eerie map ")));
  EXPECT_THAT(commands, Contains(HasSubstr("eerie check ")));
  EXPECT_THAT(commands, Contains(AllOf(HasSubstr("eerie extend "), HasSubstr("--until 600 "))));
  // Before any is pasted: an extended job is one of the sweep's.
  for (const std::string& line : commands)
    EXPECT_THAT(eerie(run).out, HasSubstr("\n    " + line + "\n"));
  for (const std::string& line : commands) {
    if (!line.starts_with("eerie ")) continue;
    EXPECT_EQ(paste(line), 0) << line << "\n" << pasted();
  }
}

TEST_F(FirstMinutes, SayThatABudgetEndedAnAutomaticChoiceAndHowItGoesOn) {
  write_small_sweep(R"({"v_imp_cm_per_s": [15, 20]})");
  const Ended ended = eerie(
      {"run", "my sweep.json", "--fidelity", "auto", "--budget", "0.0001", "--most-seeds", "4"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("numerics.particles_per_target = 100 gives way to --fidelity "
                                   "auto, which chooses it"));
  EXPECT_THAT(ended.out, HasSubstr("exceed the budget of 0.0001 core-hours"));
  EXPECT_THAT(ended.out,
              HasSubstr("\n    eerie run 'my sweep.json' --db eerie.sqlite --fidelity auto "
                        "--most-seeds 4 --budget 0.0002\n"));
}

TEST_F(FirstMinutes, CompareKernelsAndSchemesInOneRun) {
  write_small_sweep(R"({"numerics.kernel": ["wendland-c2", "cubic-spline"],
                        "numerics.scheme": ["closing-gaps", "libersky-petschek-2018"]})");
  const Ended ended = eerie(run);
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("4 of 4 jobs done"));
  EXPECT_THAT(ended.out, HasSubstr("numerics.kernel=cubic-spline"));
  EXPECT_THAT(ended.out, HasSubstr("b-over-a-q1-phi40-n100-s1.png"));
  const json rows = json::parse(eerie({"query", "--db", "my runs.sqlite", "--json"}).out);
  std::set<std::pair<std::string, int>> told_apart;
  for (const json& row : rows) told_apart.emplace(row.at("scheme"), row.at("settings"));
  EXPECT_EQ(told_apart.size(), 4u);
  const Ended chosen = eerie({"query", "--db", "my runs.sqlite", "--where",
                              "scheme=libersky-petschek-2018", "--columns", "hash,job_folder"});
  EXPECT_THAT(chosen.out, HasSubstr("my runs.sqlite.jobs/"));
  EXPECT_THAT(eerie({"query", "--db", "my runs.sqlite"}).out,
              AllOf(HasSubstr("scheme"), HasSubstr("settings 1: ")));
  const Ended both = eerie({"map", "--db", "my runs.sqlite", "-o", "map.png"});
  EXPECT_EQ(both.code, 2);
  EXPECT_THAT(both.err, HasSubstr("numerics.kernel=cubic-spline"));
  for (const json& row : rows)
    EXPECT_TRUE(fs::is_directory(folder.path() / row.at("job_folder").get<std::string>()));
}

TEST_F(FirstMinutes, TellSweepsOfOneNameApart) {
  write_small_sweep(R"({"v_imp_cm_per_s": [15]})");
  ASSERT_EQ(eerie(run).code, 0);
  write_small_sweep(R"({"v_imp_cm_per_s": [15, 20]})");
  const Ended second = eerie(run);
  EXPECT_THAT(second.out, HasSubstr("small@2: 2 jobs, 1 new"));
  EXPECT_THAT(second.out, HasSubstr("--sweep small@2 means this one"));
  EXPECT_THAT(second.out, HasSubstr("small@2-b-over-a.png"));
  const auto found = [&](const std::string& sweep) {
    return json::parse(eerie({"query", "--db", "my runs.sqlite", "--sweep", sweep, "--json"}).out)
        .size();
  };
  EXPECT_EQ(found("small@1"), 1u);
  EXPECT_EQ(found("small@2"), 2u);
  EXPECT_EQ(found("small"), 2u);
  EXPECT_THAT(eerie({"status", "--db", "my runs.sqlite"}).out, HasSubstr("small@2"));
}

}  // namespace
}  // namespace eerie
