#include <gmock/gmock.h>
#include <signal.h>
#include <sys/stat.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
namespace fs = std::filesystem;
using test::Ended;
using testing::HasSubstr;

/// A campaign whose user is told by a script, which adds a line of JSON to a file.
class Notify : public testing::Test {
 protected:
  Notify() {
    install_text(folder / "tell.sh",
                 "#!/bin/sh\n"
                 "printf '%s\\n' \"$1 $EERIE_SWEEP jobs=$EERIE_JOBS done=$EERIE_DONE "
                 "failed=$EERIE_FAILED left=$EERIE_LEFT $EERIE_MESSAGE\" >> \"${0%/*}/news\"\n"
                 "printf '%s' \"$EERIE_DATABASE\" > \"${0%/*}/database\"\n");
    ::chmod((folder / "tell.sh").c_str(), 0755);
    test::write_sweep(folder.path(), 300, R"({"v_imp_cm_per_s": [15, 20]})");
  }
  /// The news so far, once there are so many.
  std::vector<std::string> news(std::size_t lines) {
    std::vector<std::string> found;
    EXPECT_TRUE(test::eventually([&] {
      found.clear();
      std::ifstream in(folder / "news");
      for (std::string line; std::getline(in, line);) found.push_back(line);
      return found.size() >= lines;
    }));
    found.resize(lines);
    return found;
  }
  test::TemporaryFolder folder;
};

TEST_F(Notify, ARunTellsHowItEnded) {
  const Ended ended =
      test::eerie(folder.path(), {"run", "sweep.json", "--notify", "./tell.sh", "--quiet"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(news(1)[0], "ended small jobs=2 done=2 failed=0 left=0 ");
  EXPECT_EQ(read_file(folder / "database"), (folder / "eerie.sqlite").string());
}

TEST_F(Notify, ARunThatCannotBeTellsWhy) {
  install_text(folder / "text.sqlite", std::string(5000, 'x'));
  const Ended ended = test::eerie(
      folder.path(), {"run", "sweep.json", "--db", "text.sqlite", "--notify", "./tell.sh"});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(news(1)[0], testing::AllOf(HasSubstr("failed "), HasSubstr("text.sqlite")));
}

TEST_F(Notify, AnInterruptedRunTellsWhatIsLeft) {
  test::write_slow_sweep(folder.path(), R"({"v_imp_cm_per_s": [15]})");
  test::Program run(folder.path(), {"run", "sweep.json", "--notify", "./tell.sh"});
  ASSERT_TRUE(test::eventually([&] {
    const auto jobs = test::job_directories(folder / "eerie.sqlite");
    return !jobs.empty() && test::worker_at_work(jobs[0]);
  }));
  run.send(SIGINT);
  EXPECT_EQ(run.wait().code, 130);
  EXPECT_EQ(news(1)[0], "stopped small jobs=1 done=0 failed=0 left=1 ");
}

TEST_F(Notify, ADaemonTellsEachTimeThatItHasNothingLeftToDo) {
  test::Program daemon(folder.path(), {"daemon", "--notify", "./tell.sh"});
  const auto submit = [&](const std::string& grid, std::size_t done) {
    test::write_sweep(folder.path(), 300, grid);
    ASSERT_EQ(test::eerie(folder.path(), {"submit", "sweep.json"}).code, 0);
    const std::string number = std::to_string(done);
    EXPECT_EQ(news(done).back(), "idle  jobs=" + number + " done=" + number + " failed=0 left=0 ");
  };
  ASSERT_TRUE(test::eventually([&] { return fs::exists(folder / "eerie.sqlite.status.json"); }));
  submit(R"({"v_imp_cm_per_s": [15]})", 1);
  submit(R"({"v_imp_cm_per_s": [20]})", 2);
  daemon.send(SIGTERM);
  EXPECT_EQ(daemon.wait().code, 0);
  EXPECT_THAT(news(3).back(), testing::StartsWith("ended "));
}

TEST_F(Notify, AProgramThatIsNoneIsRefusedBeforeAnythingRuns) {
  const Ended ended =
      test::eerie(folder.path(), {"run", "sweep.json", "--notify", "./tell.sh done"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("run without a shell"));
  EXPECT_FALSE(fs::exists(folder / "eerie.sqlite"));
}

TEST(Version, IsToldAsJson) {
  test::TemporaryFolder folder;
  const nlohmann::json version =
      nlohmann::json::parse(test::eerie(folder.path(), {"--version", "--json"}).out);
  const std::string line = test::eerie(folder.path(), {"--version"}).out;
  EXPECT_THAT(line, HasSubstr(version.at("version").get<std::string>()));
  EXPECT_THAT(line, HasSubstr(version.at("vector").get<std::string>()));
  EXPECT_GE(version.at("database_version"), 5);
  EXPECT_TRUE(version.contains("solver_version") && version.contains("commit"));
  EXPECT_EQ(test::eerie(folder.path(), {"--json"}).code, 2);
}

}  // namespace
}  // namespace eerie
