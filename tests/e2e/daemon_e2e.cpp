#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <signal.h>

#include <nlohmann/json.hpp>

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

constexpr const char* two_points = R"({"v_imp_cm_per_s": [15, 20]})";

/// A daemon on eerie.sqlite, and its users.
class Daemon : public testing::Test {
 protected:
  Ended eerie(const std::vector<std::string>& arguments) {
    return test::eerie(folder.path(), arguments);
  }
  std::vector<std::string> daemon(std::vector<std::string> more = {}) {
    std::vector<std::string> words = {"daemon", "--workers", "2", "--min-free-mb", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  int number(const std::string& sql) { return SQLite::Database(database).execAndGet(sql).getInt(); }
  /// Asks often until the query gives the number.
  bool becomes(const std::string& sql, int wanted) {
    return test::eventually([&] { return fs::exists(database) && number(sql) == wanted; });
  }
  void wait_for_daemon() {
    ASSERT_TRUE(test::eventually([&] {
      const Ended status = eerie({"status"});
      return status.code == 0 && status.out.find("worked on by") != std::string::npos;
    }));
  }
  std::string first_hash() {
    return SQLite::Database(database).execAndGet("SELECT hash FROM jobs LIMIT 1").getString();
  }

  test::TemporaryFolder folder;
  fs::path database = folder / "eerie.sqlite";
};

TEST_F(Daemon, WorksOnWhatIsSubmittedAndEndsWhenTold) {
  Program daemon_at_work(folder.path(), daemon());
  wait_for_daemon();
  test::write_sweep(folder.path(), 1000, two_points);
  const Ended submitted = eerie({"submit", "sweep.json"});
  ASSERT_EQ(submitted.code, 0) << submitted.err;
  EXPECT_THAT(submitted.out, HasSubstr("2 jobs, 2 new"));
  EXPECT_TRUE(becomes("SELECT count(*) FROM results", 2));
  EXPECT_THAT(eerie({"submit", "sweep.json"}).out, HasSubstr("2 jobs, 0 new"));
  const Ended second = eerie(daemon());
  EXPECT_EQ(second.code, 3);
  EXPECT_THAT(second.err, HasSubstr("process " + std::to_string(daemon_at_work.pid())));
  daemon_at_work.send(SIGTERM);
  const Ended ended = daemon_at_work.wait();
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(read_file(folder / "eerie.sqlite.log"), HasSubstr("event=daemon-ends"));
  EXPECT_FALSE(fs::exists(folder / "eerie.sqlite.status.json"));
}

TEST_F(Daemon, DoesWhatWasSubmittedBeforeItCame) {
  test::write_sweep(folder.path(), 1000, two_points);
  ASSERT_EQ(eerie({"submit", "sweep.json"}).code, 0);
  const Ended ended = eerie(daemon({"--until-idle"}));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(number("SELECT count(*) FROM results"), 2);
}

TEST_F(Daemon, PausesResumesAndCancels) {
  Program daemon_at_work(folder.path(), daemon());
  wait_for_daemon();
  test::write_slow_sweep(folder.path(), R"({"v_imp_cm_per_s": [15, 20, 25]})");
  ASSERT_EQ(eerie({"submit", "sweep.json"}).code, 0);
  ASSERT_TRUE(becomes("SELECT count(*) FROM jobs WHERE state = 'running'", 2));
  EXPECT_THAT(eerie({"pause", "--all"}).out, HasSubstr("3 jobs paused"));
  ASSERT_TRUE(becomes("SELECT count(*) FROM jobs WHERE state = 'running'", 0));
  EXPECT_THAT(eerie({"status"}).out, HasSubstr("paused"));
  EXPECT_EQ(number("SELECT count(*) FROM attempts WHERE exit_reason = 'stopped'"), 2);
  EXPECT_THAT(eerie({"resume", "--v", "20"}).out, HasSubstr("1 job resumed"));
  ASSERT_TRUE(becomes("SELECT count(*) FROM jobs WHERE state = 'running'", 1));
  EXPECT_THAT(eerie({"cancel", "--all", "--json"}).out, HasSubstr("\"jobs\": 3"));
  ASSERT_TRUE(becomes("SELECT count(*) FROM jobs WHERE state = 'cancelled'", 3));
}

TEST_F(Daemon, KilledAtWorkLosesNothing) {
  test::write_sweep(folder.path(), 4000, R"({"v_imp_cm_per_s": [15, 17, 19, 21]})");
  ASSERT_EQ(eerie({"submit", "sweep.json"}).code, 0);
  for (int death = 0; death < 3; ++death) {
    Program daemon_at_work(folder.path(), daemon({"--until-idle"}));
    test::eventually([&] {
      return number("SELECT count(*) FROM attempts WHERE ended IS NULL") > 0 ||
             !daemon_at_work.running();
    });
    daemon_at_work.send(SIGKILL);
    daemon_at_work.wait();
  }
  const Ended ended = eerie(daemon({"--until-idle"}));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(number("SELECT count(*) FROM results"), 4);
  EXPECT_EQ(number("SELECT count(*) FROM attempts WHERE exit_reason = 'finished'"), 4);
  const Ended doctor = eerie({"doctor"});
  EXPECT_EQ(doctor.code, 0) << doctor.out << doctor.err;
}

TEST_F(Daemon, ShowsAJobItsLogAndItsStatus) {
  test::write_sweep(folder.path(), 1000, R"({"v_imp_cm_per_s": [15]})");
  ASSERT_EQ(eerie({"submit", "sweep.json"}).code, 0);
  EXPECT_EQ(eerie({"log", first_hash()}).code, 2) << "never started";
  ASSERT_EQ(eerie(daemon({"--until-idle"})).code, 0);
  const std::string job = first_hash().substr(0, 8);
  const Ended shown = eerie({"show", job});
  EXPECT_EQ(shown.code, 0) << shown.err;
  for (const char* part : {"impact.v_imp_cm_per_s = 15", "compiler = ", "commit = ", "finished",
                           "result.json", "numerics.seed"})
    EXPECT_THAT(shown.out, HasSubstr(part));
  const json report = json::parse(eerie({"show", job, "--json"}).out);
  EXPECT_EQ(report.at("state"), "done");
  EXPECT_EQ(report.at("attempts").size(), 1u);
  EXPECT_GT(report.at("attempts")[0].at("peak_memory_bytes").get<double>(), 1e6);
  EXPECT_THAT(eerie({"log", job, "-f"}).out, HasSubstr("done: "));
  const json status = json::parse(eerie({"status", "--json"}).out);
  EXPECT_EQ(status.at("sweeps")[0].at("jobs").at("done"), 1);
  EXPECT_TRUE(status.at("worked_on_by").is_null());
}

TEST_F(Daemon, CommandsSayWhatIsWrongWithTheirInput) {
  test::write_sweep(folder.path(), 1000, two_points);
  ASSERT_EQ(eerie({"submit", "sweep.json"}).code, 0);
  const struct {
    std::vector<std::string> arguments;
    const char* says;
  } mistakes[] = {
      {{"pause"}, "--all means every job"},
      {{"pause", "xyz"}, "JOB = xyz"},
      {{"show", "0000000000"}, "no job of"},
      {{"cancel", "--v", "20:10"}, "swap them"},
      {{"wall-limit", "soon", "--all"}, "2h"},
      {{"wall-limit", "-1h", "--all"}, "positive"},
      {{"submit", "missing.json"}, "missing.json"},
      {{"daemon", "--profile", "p.json"}, "--scheduler slurm"},
      {{"status", "--watch", "--json"}, "give one of them"},
  };
  for (const auto& [arguments, says] : mistakes) {
    const Ended ended = eerie(arguments);
    EXPECT_EQ(ended.code, 2) << arguments.front();
    EXPECT_THAT(ended.err, HasSubstr(says));
  }
  EXPECT_EQ(eerie({"pause", "--all", "--db", "none.sqlite"}).code, 3);
  EXPECT_FALSE(fs::exists(folder / "none.sqlite"));
}

TEST_F(Daemon, StopsAJobAtItsWallLimitAndGoesOnWithALargerOne) {
  test::write_slow_sweep(folder.path(), R"({"v_imp_cm_per_s": [20]})");
  ASSERT_EQ(eerie({"submit", "sweep.json", "--wall-limit", "1s"}).code, 0);
  ASSERT_EQ(eerie(daemon({"--until-idle"})).code, 0);
  EXPECT_THAT(eerie({"status"}).out, HasSubstr("1 x wall-limit"));
  EXPECT_THAT(eerie({"wall-limit", "none", "--all"}).out, HasSubstr("1 job changed"));
  EXPECT_THAT(eerie({"retry", "--all"}).out, HasSubstr("1 job will be tried again"));
  ASSERT_EQ(eerie(daemon({"--until-idle"})).code, 0);
  EXPECT_EQ(number("SELECT count(*) FROM results"), 1);
  EXPECT_THAT(eerie({"log", first_hash()}).out, HasSubstr("going on from"));
}

TEST_F(Daemon, IsHardlyAtWorkWhenThereIsNothingToDo) {
  Program daemon_at_work(folder.path(), daemon());
  wait_for_daemon();
  const auto ticks = [&] { return test::processor_ticks(daemon_at_work.pid()); };
  const auto start = std::chrono::steady_clock::now();
  const long before = ticks();
  test::eventually(
      [&] { return std::chrono::steady_clock::now() - start > std::chrono::seconds(4); });
  EXPECT_LE(ticks() - before, 20) << "of 400";
}

}  // namespace
}  // namespace eerie
