// Files are where the user said: links, devices, typos, pipes, names of any bytes, folders of
// others.

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr const char* scene =
    R"({"numerics": {"particles_per_target": 100}, "end": {"time_s": 600}})";

class Files : public testing::Test {
 protected:
  Files() { test::write_sweep(folder.path(), 300, R"({"v_imp_cm_per_s": [15, 20]})"); }

  Ended eerie(const std::vector<std::string>& arguments) {
    return test::eerie(folder.path(), arguments);
  }
  /// `line`, for a shell in the folder, in which "eerie" is the program.
  int shell(const std::string& line) {
    const std::string all = "cd '" + folder.path().string() + "' && eerie() { '" +
                            test::program().string() + "' \"$@\"; } && { " + line +
                            "; } > out 2> err";
    return WEXITSTATUS(std::system(all.c_str()));
  }
  std::string out() { return read_file(folder / "out"); }
  std::string err() { return read_file(folder / "err"); }
  void write(const char* name, const std::string& text) { std::ofstream(folder / name) << text; }

  test::TemporaryFolder folder;
};

TEST_F(Files, BehindLinksAreReplacedAndDevicesAreWrittenInto) {
  ASSERT_EQ(eerie({"run", "sweep.json", "--json"}).code, 0);
  write("target.csv", "old");
  fs::create_symlink("target.csv", folder / "link.csv");
  EXPECT_EQ(eerie({"query", "--format", "csv", "-o", "link.csv"}).code, 0);
  EXPECT_TRUE(fs::is_symlink(folder / "link.csv"));
  EXPECT_THAT(read_file(folder / "target.csv"), HasSubstr("v_imp_cm_per_s"));
  EXPECT_EQ(shell("eerie query --format csv -o /dev/stdout | head -n 1"), 0);
  EXPECT_THAT(out(), HasSubstr("v_imp_cm_per_s")) << err();
  if (::mknod((folder / "null").c_str(), S_IFCHR | 0666, makedev(1, 3)) != 0)
    GTEST_SKIP() << "only root may make devices";
  EXPECT_EQ(eerie({"query", "--format", "csv", "-o", "null"}).code, 0);
  EXPECT_TRUE(fs::is_character_file(folder / "null"));
}

TEST_F(Files, NeverMakeFoldersForATypo) {
  ASSERT_EQ(eerie({"run", "sweep.json", "--json"}).code, 0);
  ASSERT_EQ(eerie({"catalogue", "export", "-o", "impacts.csv"}).code, 0);
  const std::string job = test::job_directories(folder / "eerie.sqlite").at(0).string();
  const std::vector<std::vector<std::string>> commands = {
      {"query", "-o", "none/a.csv"},
      {"catalogue", "export", "-o", "none/a.csv"},
      {"map", "-o", "none/a.png"},
      {"sizes", "-o", "none/a.svg"},
      {"check", "-o", "none/a.md"},
      {"run", "sweep.json", "--map", "none/a.png"},
      {"run", "sweep.json", "--db", "none/below/a.sqlite"},
      {"submit", "sweep.json", "--db", "none/below/a.sqlite"},
      {"run", "sweep.json", "--jobs-dir", "none/below"},
      {"run", "sweep.json", "--fidelity", "auto", "--db", "none/below/a.sqlite"},
      {"daemon", "--db", "none/below/a.sqlite", "--until-idle"},
      {"threshold", "-o", "none/a.csv"},
      {"threshold", "-o", "none/a.svg"},
      {"catalogue", "import", "impacts.csv", "-o", "none/a.json"},
      {"show", job, "-o", "none/a.png"},
      {"show", job, "--movie", "none/a.mp4"},
      {"lightcurve", job, "-o", "none/a.svg"},
      {"disk", "-o", "none/below"},
      {"solve", "scene.json", "--out", "none/below"}};
  write("scene.json", scene);
  for (const auto& command : commands) {
    const Ended ended = eerie(command);
    EXPECT_EQ(ended.code, 2) << command[0] << ": " << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("there is no folder none")) << command[0];
    EXPECT_FALSE(fs::exists(folder / "none")) << command[0];
  }
}

TEST_F(Files, MayBePipesOrStandardInput) {
  write("scene.json", scene);
  EXPECT_EQ(shell("cat sweep.json | eerie expand - --json"), 0) << err();
  EXPECT_EQ(json::parse(out()).at("jobs"), 2);
  EXPECT_EQ(shell("cat sweep.json | eerie run /dev/stdin --json"), 0) << err();
  EXPECT_EQ(json::parse(out()).at("results").size(), 2u);
  EXPECT_EQ(shell("mkfifo p; cat scene.json > p & eerie solve p --out o --max-steps 3"), 0)
      << err();
  EXPECT_EQ(shell("eerie catalogue export | eerie catalogue import - -o again.json"), 0) << err();
  EXPECT_EQ(json::parse(read_file(folder / "again.json")).at("points").size(), 2u);
  EXPECT_EQ(shell("eerie catalogue export | eerie catalogue import -"), 2);
  EXPECT_THAT(err(), HasSubstr("give -o SWEEP.json"));
  EXPECT_EQ(shell("echo '{' | eerie expand -"), 2);
  EXPECT_THAT(err(), HasSubstr("standard input, line"));
  EXPECT_EQ(shell("eerie converge - -o s --budget 1 < /dev/null"), 2);
  EXPECT_THAT(err(), HasSubstr("standard input"));
}

TEST_F(Files, MayHaveNamesOfAnyBytes) {
  const std::string name = "d\xff.sqlite";
  const Ended ran = eerie({"run", "sweep.json", "--db", name, "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_THAT(json::parse(ran.out).dump(), HasSubstr(R"(d\\xff)"));
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"status"}, {"doctor"}, {"query"}, {"map", "-o", "m\xfe.svg"}, {"threshold"}}) {
    std::vector<std::string> words = command;
    for (const char* word : {"--db", name.c_str(), "--json"}) words.emplace_back(word);
    const Ended ended = eerie(words);
    EXPECT_EQ(ended.code, 0) << command[0] << ": " << ended.err;
    EXPECT_FALSE(json::parse(ended.out, nullptr, false).is_discarded()) << command[0];
  }
  EXPECT_TRUE(fs::exists(folder / "m\xfe.svg"));
  write("scene.json", scene);
  EXPECT_EQ(eerie({"solve", "scene.json", "--out", "o\xff", "--json"}).code, 0);
}

class SolveFolder : public Files {
 protected:
  SolveFolder() {
    write("scene.json", scene);
    write("other.json", R"({"numerics": {"particles_per_target": 100}, "end": {"time_s": 700}})");
  }
  Ended solve(const std::string& file, std::vector<std::string> more = {}) {
    std::vector<std::string> words = {"solve", file, "--out", "o"};
    words.insert(words.end(), more.begin(), more.end());
    return eerie(words);
  }
  /// Until there is a checkpoint, and no result yet.
  void stop_midway() {
    for (int k = 0; k < 50 && !fs::exists(folder / "o/checkpoint.hdf5"); ++k)
      ASSERT_EQ(solve("scene.json", {"--max-steps", "40"}).code, 0);
    ASSERT_TRUE(fs::exists(folder / "o/checkpoint.hdf5"));
    ASSERT_FALSE(fs::exists(folder / "o/result.json"));
  }
};

TEST_F(SolveFolder, WithAnotherScenesWorkIsRefusedAndStaysAsItIs) {
  stop_midway();
  const std::string checkpoint = read_file(folder / "o/checkpoint.hdf5");
  for (const Ended& ended :
       {solve("other.json"), solve("scene.json", {"--set", "end.time_s=700"})}) {
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.err, HasSubstr("of another scene"));
  }
  EXPECT_EQ(read_file(folder / "o/checkpoint.hdf5"), checkpoint);
  EXPECT_EQ(solve("scene.json").code, 0) << "it goes on";
}

TEST_F(SolveFolder, WithTheResultSaysThatItIsDone) {
  ASSERT_EQ(solve("scene.json").code, 0);
  const std::string result = read_file(folder / "o/result.json");
  const Ended again = solve("scene.json");
  EXPECT_EQ(again.code, 0);
  EXPECT_THAT(again.out, HasSubstr("this scene is done"));
  EXPECT_EQ(json::parse(solve("scene.json", {"--json"}).out).at("analysis"),
            json::parse(result).at("analysis"));
  EXPECT_EQ(read_file(folder / "o/result.json"), result);
}

TEST_F(SolveFolder, KeepsACheckpointThatItCannotGoOnFrom) {
  stop_midway();
  write("o/checkpoint.hdf5", "damaged");
  fs::remove(folder / "o/checkpoint_previous.hdf5");
  const Ended ended = solve("scene.json");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("would write over it"));
  EXPECT_EQ(read_file(folder / "o/checkpoint.hdf5"), "damaged");
  fs::remove(folder / "o/scene.json");
  EXPECT_THAT(solve("scene.json").err, HasSubstr("no scene.json"));
}

TEST_F(SolveFolder, DoesNotRewriteTheSceneFileThatTheUserWrote) {
  fs::create_directory(folder / "o");
  write("o/scene.json", scene);
  EXPECT_EQ(solve("o/scene.json", {"--max-steps", "3"}).code, 0);
  EXPECT_EQ(read_file(folder / "o/scene.json"), scene);
  const Ended changed = solve("o/scene.json", {"--set", "end.time_s=700"});
  EXPECT_EQ(changed.code, 2);
  EXPECT_EQ(read_file(folder / "o/scene.json"), scene);
}

}  // namespace
}  // namespace eerie
