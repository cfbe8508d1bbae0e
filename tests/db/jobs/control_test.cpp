#include "db/jobs/control.hpp"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include "db/store/settings.hpp"
#include "db/views/query.hpp"
#include "tests/db/jobs/sample_jobs.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::db {
namespace {
using test::ended;
using test::sample_jobs;
using test::sample_result;

class Control : public testing::Test {
 protected:
  void SetUp() override { add_sweep(connection, "s", "{}", sample_jobs(4)); }

  template <class Change, class... Arguments>
  std::size_t ask(Change change, const Selection& selection, Arguments... arguments) {
    std::size_t count = 0;
    connection.write([&](SQLite::Database& sql) { count = change(sql, selection, arguments...); });
    return count;
  }
  void start(std::int64_t job) {
    begin_attempts(connection, std::vector{Start{job, "here", "1", "0.1.0"}});
  }
  Job job(std::int64_t id) {
    for (const Job& row : jobs(connection, {}))
      if (row.id == id) return row;
    ADD_FAILURE() << "no job " << id;
    return {};
  }
  std::vector<std::int64_t> next(std::size_t most = 100) {
    std::vector<std::int64_t> ids;
    for (const Job& row : next_jobs(connection, std::nullopt, most)) ids.push_back(row.id);
    return ids;
  }

  test::TemporaryFolder folder;
  Connection connection{folder / "a.sqlite", Access::write};
};

TEST_F(Control, PausedJobsAreNotNextAndResumedOnesAre) {
  EXPECT_EQ(ask(pause, {.v_imp_cm_per_s = Range{16, 17}}), 2u);
  EXPECT_EQ(ask(pause, {.v_imp_cm_per_s = Range{16, 17}}), 0u);
  EXPECT_THAT(next(), testing::ElementsAre(4, 1));
  EXPECT_EQ(count_jobs(connection, std::nullopt).paused, 2u);
  EXPECT_EQ(ask(resume, {}), 2u);
  EXPECT_THAT(next(), testing::ElementsAre(4, 3, 2, 1));
}

TEST_F(Control, ARunningJobThatIsPausedIsUnwantedAndPendingOnceItStopped) {
  start(2);
  EXPECT_TRUE(unwanted_jobs(connection).empty());
  EXPECT_EQ(ask(pause, {.hashes = {"hash-1"}}), 1u);
  ASSERT_EQ(unwanted_jobs(connection).size(), 1u);
  EXPECT_EQ(unwanted_jobs(connection)[0].id, 2);
  EXPECT_EQ(end_attempt(connection, 2, ended(ExitReason::stopped), JobState::pending),
            JobState::pending);
  EXPECT_EQ(job(2).wanted, Wanted::pause);
}

TEST_F(Control, ARunningJobThatIsCancelledIsCancelledOnceItStopped) {
  start(2);
  EXPECT_EQ(ask(cancel, {}), 4u);
  EXPECT_EQ(job(1).state, JobState::cancelled);
  EXPECT_EQ(job(2).state, JobState::running);
  EXPECT_EQ(end_attempt(connection, 2, ended(ExitReason::stopped), JobState::pending),
            JobState::cancelled);
  EXPECT_EQ(job(2).wanted, Wanted::run);
}

TEST_F(Control, ACancelledJobThatGotThroughInTheMeantimeIsDone) {
  start(2);
  ask(cancel, {});
  finish(connection, 2, ended(ExitReason::finished), sample_result(0.24), {});
  EXPECT_EQ(job(2).state, JobState::done);
  EXPECT_EQ(job(2).wanted, Wanted::run);
}

TEST_F(Control, CancelLeavesResultsAlone) {
  finish(connection, 1, ended(ExitReason::finished), sample_result(0.24), {});
  EXPECT_EQ(ask(cancel, {}), 3u);
  EXPECT_EQ(job(1).state, JobState::done);
}

TEST_F(Control, RetryGivesACleanSlate) {
  start(1);
  end_attempt(connection, 1, ended(ExitReason::crashed), JobState::failed);
  ask(cancel, {.hashes = {"hash-2"}});
  EXPECT_EQ(ask(retry, {}), 2u);
  EXPECT_EQ(job(1).state, JobState::pending);
  EXPECT_EQ(job(1).crashes, 0);
}

TEST_F(Control, HigherPrioritiesComeFirst) {
  EXPECT_EQ(ask(set_priority, {.hashes = {"hash-1"}}, 5), 1u);
  EXPECT_EQ(ask(set_priority, {.hashes = {"hash-3"}}, -1), 1u);
  EXPECT_THAT(next(), testing::ElementsAre(2, 3, 1, 4));
  EXPECT_THAT(next(1), testing::ElementsAre(2));
}

TEST_F(Control, ResultsOfAnotherSolverAreStaleAndRerunOnRequestAlone) {
  set(connection, "solver_version", "0.1.0");
  finish(connection, 1, ended(ExitReason::finished), sample_result(0.24), {});
  EXPECT_FALSE(results(connection, {}).at(0).stale);
  EXPECT_EQ(ask(rerun_stale, {}), 0u);
  set(connection, "solver_version", "0.2.0");
  const ResultRow row = results(connection, {}).at(0);
  EXPECT_TRUE(row.stale);
  EXPECT_EQ(row.stale_reason, "made by solver 0.1.0, this one is 0.2.0");
  EXPECT_EQ(sweep_status(connection).at(0).stale, 1);
  EXPECT_EQ(job(1).state, JobState::done);
  EXPECT_EQ(ask(rerun_stale, {}), 1u);
  EXPECT_EQ(job(1).state, JobState::pending);
  EXPECT_EQ(results(connection, {}).size(), 1u) << "the old result stays until there is a new one";
}

TEST_F(Control, SelectsByEveryCondition) {
  EXPECT_EQ(jobs(connection, {.selection = {.sweep = "s"}}).size(), 4u);
  EXPECT_EQ(jobs(connection, {.selection = {.sweep = "other"}}).size(), 0u);
  EXPECT_EQ(jobs(connection, {.selection = {.hashes = {"hash-0", "hash-3"}}}).size(), 2u);
  EXPECT_EQ(jobs(connection, {.selection = {.q = 0.5}}).size(), 0u);
  EXPECT_EQ(jobs(connection, {.selection = {.phi_d_deg = 40}}).size(), 4u);
  EXPECT_EQ(jobs(connection, {.selection = {.theta_imp_deg = Range{20, 30}}}).size(), 0u);
}

TEST_F(Control, ARequestIsCarriedOutOnceHoweverOftenItIsRead) {
  int times = 0;
  const auto body = [&](SQLite::Database&) { return std::to_string(++times); };
  EXPECT_EQ(answer(connection, "r1"), std::nullopt);
  EXPECT_EQ(once(connection, "r1", "pause", body), "1");
  EXPECT_EQ(once(connection, "r1", "pause", body), "1");
  EXPECT_EQ(once(connection, "r2", "pause", body), "2");
  EXPECT_EQ(answer(connection, "r1"), "1");
}

TEST_F(Control, ARequestThatFailsLeavesNoTrace) {
  EXPECT_THROW(once(connection, "r1", "x",
                    [](SQLite::Database& sql) -> std::string {
                      sql.exec("UPDATE jobs SET priority = 9");
                      throw std::runtime_error("no");
                    }),
               std::runtime_error);
  EXPECT_EQ(job(1).priority, 0);
  EXPECT_EQ(answer(connection, "r1"), std::nullopt);
}

TEST_F(Control, WallTimeAddsUpOverAttemptsUntilANewLimitIsSet) {
  AttemptEnd end = ended(ExitReason::stopped);
  end.wall_s = 40;
  for (int i = 0; i < 2; ++i) start(1), end_attempt(connection, 1, end, JobState::pending);
  EXPECT_EQ(job(1).wall_s, 80);
  EXPECT_EQ(ask(set_wall_limit, {}, std::optional<double>(100.0)), 4u);
  EXPECT_EQ(job(1).wall_s, 0);
  EXPECT_EQ(job(1).wall_limit_s, 100.0);
}

}  // namespace
}  // namespace eerie::db
