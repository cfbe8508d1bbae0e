#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <signal.h>

#include <nlohmann/json.hpp>

#include "campaign/job_folder/worker_lock.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using test::Program;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// A sweep of two jobs that take long enough to be cut off.
class Interrupted : public testing::Test {
 protected:
  void SetUp() override {
    test::write_slow_sweep(folder.path(), R"({"v_imp_cm_per_s": [15, 20]})");
  }

  Ended eerie(const std::vector<std::string>& arguments) {
    return test::eerie(folder.path(), arguments);
  }

  /// The worker of any of the jobs, once one takes steps and has a checkpoint to lose.
  pid_t some_worker() {
    pid_t found = 0;
    EXPECT_TRUE(test::eventually([&] {
      for (const fs::path& job : test::job_directories(database))
        if (const auto pid = test::worker_at_work(job); pid && fs::exists(job / "checkpoint.hdf5"))
          found = *pid;
      return found != 0;
    }));
    return found;
  }
  int number(const std::string& sql) { return SQLite::Database(database).execAndGet(sql).getInt(); }

  /// What the impacts left behind, without what the machine's mood decides.
  std::vector<json> outcomes(const fs::path& of) {
    std::vector<json> all;
    for (const fs::path& job : test::job_directories(of))
      all.push_back(json::parse(read_file(job / "result.json")).at("analysis"));
    return all;
  }
  void expect_the_outcomes_of_an_undisturbed_run() {
    ASSERT_EQ(eerie({"run", "sweep.json", "--db", "calm.sqlite", "--workers", "2"}).code, 0);
    EXPECT_EQ(outcomes(database), outcomes(folder / "calm.sqlite"));
  }

  test::TemporaryFolder folder;
  fs::path database = folder / "eerie.sqlite";
};

TEST_F(Interrupted, ByCtrlCLeavesCheckpointsFromWhichTheNextRunGoesOn) {
  Program run(folder.path(), {"run", "sweep.json", "--workers", "2"});
  some_worker();
  run.send(SIGINT);
  const Ended stopped = run.wait();
  EXPECT_EQ(stopped.code, 130);
  EXPECT_THAT(stopped.err, HasSubstr("the same command goes on from the checkpoints"));
  EXPECT_EQ(number("SELECT count(*) FROM jobs WHERE state = 'running'"), 0);
  EXPECT_EQ(number("SELECT count(*) FROM attempts WHERE ended IS NULL"), 0);
  EXPECT_GE(number("SELECT count(*) FROM attempts WHERE exit_reason = 'stopped'"), 1);
  EXPECT_EQ(SQLite::Database(database).execAndGet("PRAGMA integrity_check").getString(), "ok");

  const Ended resumed = eerie({"run", "sweep.json", "--workers", "2"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(number("SELECT count(*) FROM results"), 2);
  expect_the_outcomes_of_an_undisturbed_run();
}

TEST_F(Interrupted, ByTheDeathOfAWorkerGoesOnFromItsCheckpoint) {
  Program run(folder.path(), {"run", "sweep.json", "--workers", "2"});
  ASSERT_EQ(::kill(some_worker(), SIGKILL), 0);
  const Ended ended = run.wait();
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(number("SELECT count(*) FROM attempts WHERE exit_reason = 'crashed' AND failure_kind = "
                   "'signal 9'"),
            1);
  EXPECT_EQ(number("SELECT count(*) FROM results"), 2);
  std::string logs;
  for (const fs::path& job : test::job_directories(database)) logs += read_file(job / "log.txt");
  EXPECT_THAT(logs, HasSubstr("going on from"));
  expect_the_outcomes_of_an_undisturbed_run();
}

TEST_F(Interrupted, ThreeTimesByTheDeathOfItsWorkerAJobFailsAndCanBeRetried) {
  test::write_slow_sweep(folder.path(), R"({"v_imp_cm_per_s": [20]})");
  Program run(folder.path(), {"run", "sweep.json"});
  pid_t last = 0;
  for (int death = 0; death < 3; ++death) {
    pid_t pid = last;
    ASSERT_TRUE(test::eventually([&] { return (pid = some_worker()) != last; }));
    ASSERT_EQ(::kill(last = pid, SIGKILL), 0);
  }
  const Ended ended = run.wait();
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out, HasSubstr("signal 9"));
  EXPECT_EQ(eerie({"run", "sweep.json"}).code, 1);
  EXPECT_EQ(eerie({"run", "sweep.json", "--retry-failed"}).code, 0);
}

TEST_F(Interrupted, ByTheDeathOfTheManagerLosesNothingAndDoublesNothing) {
  Program run(folder.path(), {"run", "sweep.json", "--workers", "2"});
  some_worker();
  run.send(SIGKILL);
  EXPECT_EQ(run.wait().code, 128 + SIGKILL);
  // Nobody unlocks anything by hand, and the workers end by themselves, now or a little later.
  const Ended resumed = eerie({"run", "sweep.json", "--workers", "2"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(number("SELECT count(*) FROM results"), 2);
  EXPECT_EQ(number("SELECT count(*) FROM attempts WHERE exit_reason = 'finished'"), 2);
  EXPECT_EQ(number("SELECT count(*) FROM attempts WHERE exit_reason = 'crashed'"), 0);
  expect_the_outcomes_of_an_undisturbed_run();
}

TEST_F(Interrupted, WorkersEndWhenTheirManagerDies) {
  Program run(folder.path(), {"run", "sweep.json", "--workers", "2"});
  some_worker();
  run.send(SIGKILL);
  run.wait();
  EXPECT_TRUE(test::eventually([&] {
    for (const fs::path& job : test::job_directories(database))
      if (job_folder::WorkerLock::held({job})) return false;
    return true;
  }));
}

TEST_F(Interrupted, NotByASecondManagerWhichIsToldWhoHoldsTheDatabase) {
  Program first(folder.path(), {"run", "sweep.json", "--workers", "2"});
  some_worker();
  const Ended second = eerie({"run", "sweep.json"});
  EXPECT_EQ(second.code, 3);
  EXPECT_THAT(second.err, HasSubstr("process " + std::to_string(first.pid())));
  const Ended status = eerie({"status"});
  EXPECT_EQ(status.code, 0);
  EXPECT_THAT(status.out, HasSubstr("worked on by process " + std::to_string(first.pid())));
  EXPECT_EQ(first.wait().code, 0);
}

}  // namespace
}  // namespace eerie
