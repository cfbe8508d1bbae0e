// The real program between other programs: pipes that close, terminals that go, names that lie.

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <signal.h>

#include <cstdlib>
#include <fstream>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using test::Ended;
using test::Program;
using testing::HasSubstr;
namespace fs = std::filesystem;

class Around : public testing::Test {
 protected:
  void SetUp() override { test::write_sweep(folder.path(), 1000, R"({"v_imp_cm_per_s": [15]})"); }

  Ended eerie(const std::vector<std::string>& arguments) {
    return test::eerie(folder.path(), arguments);
  }
  /// Exit code of a line of bash, in which $EERIE is the program.
  int bash(const std::string& line) {
    const std::string command = "cd '" + folder.path().string() + "' && EERIE='" +
                                test::program().string() + "' bash -c '" + line + "' >/dev/null";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  int number(const std::string& sql) {
    return SQLite::Database(folder / "eerie.sqlite").execAndGet(sql).getInt();
  }
  bool says_waiting(const Program& program) {
    return program.said().find("waiting: ") != std::string::npos;
  }
  int done() { return number("SELECT count(*) FROM results"); }
  void write_endless_scene() {
    std::ofstream(folder / "scene.json")
        << R"({"numerics": {"particles_per_target": 300, "cfl": 1e-9}})";
  }

  test::TemporaryFolder folder;
};

TEST_F(Around, ARunWhoseProgressCannotBeWrittenGoesOn) {
  EXPECT_EQ(bash("$EERIE run sweep.json --min-free-mb 0 2>/dev/full"), 0);
  EXPECT_EQ(done(), 1);
}

TEST_F(Around, ARunOrADaemonWhoseReaderLeavesGoesOn) {
  bash("$EERIE run sweep.json --min-free-mb 0 2>&1 | head -c 1");
  EXPECT_EQ(done(), 1);
  test::write_sweep(folder.path(), 1000, R"({"v_imp_cm_per_s": [15, 16]})");
  ASSERT_EQ(eerie({"submit", "sweep.json"}).code, 0);
  EXPECT_EQ(bash("$EERIE daemon --until-idle --min-free-mb 0 2>&1 | head -c 1; "
                 "exit ${PIPESTATUS[0]}"),
            0);
  EXPECT_EQ(done(), 2);
}

TEST_F(Around, AnImpactWhoseTerminalGoesLeavesACheckpoint) {
  std::ofstream(folder / "scene.json")
      << R"({"numerics": {"particles_per_target": 100}, "end": {"time_s": 1e7}})";
  Program solve(folder.path(), {"solve", "scene.json", "--out", "o", "--threads", "1"});
  ASSERT_TRUE(test::eventually([&] { return fs::exists(folder / "o/snapshot_0000.hdf5"); }));
  solve.send(SIGHUP);
  EXPECT_EQ(solve.wait().code, 130);
  EXPECT_TRUE(fs::exists(folder / "o/checkpoint.hdf5"));
}

TEST_F(Around, AnImpactWhoseBodiesNeverSettleStopsWhenTold) {
  write_endless_scene();
  Program solve(folder.path(), {"solve", "scene.json", "--out", "o", "--threads", "1"});
  ASSERT_TRUE(test::eventually([&] { return fs::exists(folder / "o/log.txt"); }));
  solve.send(SIGTERM);
  EXPECT_EQ(solve.wait(std::chrono::seconds(30)).code, 130);
  EXPECT_EQ(
      eerie({"solve", "scene.json", "--out", "p", "--max-steps", "10", "--threads", "1"}).code, 0);
}

TEST_F(Around, AWorkerWhoseBodiesNeverSettleEndsWithItsKilledManager) {
  install_text(folder / "sweep.json",
               R"({"name": "endless", "scene": {"numerics": {"particles_per_target": 300,
                  "cfl": 1e-9}}, "grid": {"v_imp_cm_per_s": [15]}})");
  ASSERT_EQ(eerie({"submit", "sweep.json"}).code, 0);
  Program daemon(folder.path(), {"daemon", "--min-free-mb", "0"});
  fs::path job;
  ASSERT_TRUE(test::eventually([&] {
    const auto jobs = test::job_directories(folder / "eerie.sqlite");
    if (!jobs.empty()) job = jobs[0];
    return !jobs.empty() && fs::exists(job / "heartbeat.json");
  }));
  daemon.send(SIGKILL);
  EXPECT_TRUE(
      test::eventually([&] { return fs::exists(job / "ended.json"); }, std::chrono::seconds(30)));
}

TEST_F(Around, ARunWhoseDatabaseIsRemovedSaysSo) {
  test::write_slow_sweep(folder.path(), R"({"v_imp_cm_per_s": [15, 16]})");
  Program run(folder.path(), {"run", "sweep.json", "--min-free-mb", "0"});
  ASSERT_TRUE(test::eventually([&] {
    return fs::exists(folder / "eerie.sqlite.log") &&
           number("SELECT count(*) FROM jobs WHERE state = 'running'") > 0;
  }));
  for (const char* name : {"eerie.sqlite", "eerie.sqlite-wal", "eerie.sqlite-shm"})
    fs::remove(folder / name);
  const Ended ended = run.wait();
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("removed"));
}

TEST_F(Around, ASecondDaemonThroughALinkIsToldWhoIsAtWork) {
  fs::create_symlink("eerie.sqlite", folder / "link.sqlite");
  Program first(folder.path(), {"daemon", "--min-free-mb", "0"});
  ASSERT_TRUE(test::eventually([&] { return fs::exists(folder / "eerie.sqlite.status.json"); }));
  const Ended second = eerie({"daemon", "--db", "link.sqlite"});
  EXPECT_EQ(second.code, 3);
  EXPECT_THAT(second.err, HasSubstr("process " + std::to_string(first.pid())));
  EXPECT_FALSE(fs::exists(folder / "link.sqlite.jobs"));
  // A request through the link reaches it.
  ASSERT_EQ(eerie({"submit", "sweep.json", "--db", "link.sqlite"}).code, 0);
  EXPECT_TRUE(test::eventually([&] { return done() == 1; }));
  fs::create_hard_link(folder / "eerie.sqlite", folder / "hard.sqlite");
  const Ended third = eerie({"daemon", "--db", "hard.sqlite"});
  EXPECT_EQ(third.code, 3);
  EXPECT_THAT(third.err, HasSubstr("hard links"));
  fs::remove(folder / "hard.sqlite");
  first.send(SIGTERM);
  EXPECT_EQ(first.wait().code, 0);
}

TEST_F(Around, ADatabaseThatWouldKeepNothingIsRefused) {
  for (const char* name :
       {":memory:", "", "file:a.sqlite", "file:a?mode=memory", "file:below/a.sqlite"}) {
    const Ended run = eerie({"run", "sweep.json", "--db", name});
    EXPECT_EQ(run.code, 2) << name << run.err;
    EXPECT_EQ(eerie({"submit", "sweep.json", "--db", name}).code, 2);
  }
  EXPECT_FALSE(fs::exists(folder / "a.sqlite"));
  EXPECT_FALSE(fs::exists(folder / "file:below"));
}

TEST_F(Around, NumbersThatAreNoneAreRefusedBeforeAnythingIsDone) {
  const std::vector<std::vector<std::string>> commands = {
      {"run", "sweep.json", "--min-free-mb"},
      {"run", "sweep.json", "--fidelity", "auto", "--budget"},
      {"run", "sweep.json", "--fidelity", "auto", "--confidence"},
      {"daemon", "--until-idle", "--min-free-mb"},
      {"query", "--q"},
      {"map", "-o", "map.csv", "--phi-d"},
      {"disk", "--r"}};
  for (const std::vector<std::string>& command : commands)
    for (const char* number : {"nan", "-nan", "inf", "-inf", "1e999"}) {
      std::vector<std::string> words = command;
      words.back() += std::string("=") + number;
      const Ended ended = eerie(words);
      EXPECT_EQ(ended.code, 2) << words.front() << " " << words.back() << ": " << ended.err;
      EXPECT_THAT(ended.err, HasSubstr(command.back())) << words.front();
    }
  EXPECT_FALSE(fs::exists(folder / "eerie.sqlite"));
}

TEST_F(Around, AFolderOfJobsIsTriedBeforeItIsStored) {
  for (const char* file : {"sweep.json", "sweep.json/jobs"}) {
    const Ended wrong = eerie({"run", "sweep.json", "--jobs-dir", file});
    EXPECT_EQ(wrong.code, 2) << wrong.err;
    EXPECT_THAT(wrong.err, HasSubstr("--jobs-dir"));
  }
  EXPECT_EQ(eerie({"run", "sweep.json", "--min-free-mb", "0"}).code, 0);
}

/// Another program's transaction that writes.
class Writer {
 public:
  explicit Writer(const fs::path& database) : sql_(database, SQLite::OPEN_READWRITE) {
    sql_.exec("BEGIN IMMEDIATE");
  }
  void end() { sql_.exec("COMMIT"); }

 private:
  SQLite::Database sql_;
};

TEST_F(Around, ARunThatCannotAddItsSweepYetSaysSoAndWaits) {
  ASSERT_EQ(eerie({"run", "sweep.json", "--min-free-mb", "0"}).code, 0);
  test::write_sweep(folder.path(), 1000, R"({"v_imp_cm_per_s": [16]})");
  Writer writer(folder / "eerie.sqlite");
  Program run(folder.path(), {"run", "sweep.json", "--min-free-mb", "0", "--jobs-dir",
                              (folder / "eerie.sqlite.jobs").string()});
  ASSERT_TRUE(test::eventually([&] { return says_waiting(run); }));
  EXPECT_TRUE(run.running());
  writer.end();
  EXPECT_EQ(run.wait().code, 0) << run.said();
  EXPECT_EQ(done(), 2);
}

TEST_F(Around, ARunThatWaitsForTheDatabaseIsStoppedBySigterm) {
  ASSERT_EQ(eerie({"run", "sweep.json", "--min-free-mb", "0"}).code, 0);
  const Writer writer(folder / "eerie.sqlite");
  Program run(folder.path(), {"run", "sweep.json", "--min-free-mb", "0"});
  ASSERT_TRUE(test::eventually([&] { return says_waiting(run); }));
  run.send(SIGTERM);
  const Ended ended = run.wait();
  EXPECT_EQ(ended.code, 130);
  EXPECT_THAT(ended.err, HasSubstr("stopped before the work began"));
}

TEST_F(Around, ADaemonThatStartsWaitsForACommandThatIsAtWork) {
  ASSERT_EQ(eerie({"submit", "sweep.json"}).code, 0);
  for (int k = 0; k < 10; ++k) {
    Program change(folder.path(), {"priority", std::to_string(k), "--all"});
    EXPECT_EQ(eerie({"daemon", "--until-idle", "--min-free-mb", "0"}).code, 0);
    change.wait();
  }
}

}  // namespace
}  // namespace eerie
