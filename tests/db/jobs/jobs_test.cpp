#include "db/jobs/jobs.hpp"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>


#include "db/jobs/control.hpp"
#include "db/store/error.hpp"
#include "db/views/query.hpp"
#include "tests/db/jobs/sample_jobs.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::db {
namespace {
using test::ended;
using test::sample_jobs;
using test::sample_result;

class Jobs : public testing::Test {
 protected:
  std::int64_t count(const std::string& table) {
    std::int64_t rows = 0;
    connection.read([&](SQLite::Database& sql) {
      rows = sql.execAndGet("SELECT count(*) FROM " + table).getInt64();
    });
    return rows;
  }
  Job job(std::int64_t id) {
    for (const Job& row : jobs(connection, {}))
      if (row.id == id) return row;
    throw Error("no such job");
  }

  test::TemporaryFolder folder;
  Connection connection{folder / "a.sqlite", Access::write};
};

TEST_F(Jobs, OfASweepAddedTwiceAreAddedOnce) {
  const AddedSweep first = add_sweep(connection, "s", "{}", sample_jobs(5));
  const AddedSweep second = add_sweep(connection, "s", "{}", sample_jobs(5));
  EXPECT_EQ(first.added, 5u);
  EXPECT_EQ(second.added, 0u);
  EXPECT_EQ(second.jobs, 5u);
  EXPECT_EQ(second.sweep, first.sweep);
  for (const auto& [table, rows] :
       {std::pair{"sweeps", 1}, {"jobs", 5}, {"job_scenes", 5}, {"sweep_jobs", 5}})
    EXPECT_EQ(count(table), rows) << table;
}

TEST_F(Jobs, SharedByTwoSweepsExistOnce) {
  const AddedSweep first = add_sweep(connection, "a", "{}", sample_jobs(3));
  EXPECT_EQ(count_unknown(connection, sample_jobs(5)), 2u);
  const AddedSweep second = add_sweep(connection, "b", "{}", sample_jobs(5));
  EXPECT_EQ(second.added, 2u);
  EXPECT_EQ(jobs(connection, {first.sweep, std::nullopt}).size(), 3u);
  EXPECT_EQ(jobs(connection, {second.sweep, std::nullopt}).size(), 5u);
  EXPECT_EQ(count("jobs"), 5);
}

TEST_F(Jobs, ComeLongestFirst) {
  add_sweep(connection, "s", "{}", sample_jobs(4));
  std::vector<double> lengths;
  for (const Job& row : jobs(connection, {std::nullopt, JobState::pending}))
    lengths.push_back(row.expected_particle_steps);
  EXPECT_THAT(lengths, testing::ElementsAre(1e6 + 3, 1e6 + 2, 1e6 + 1, 1e6));
}

TEST_F(Jobs, ComeByTheirPriorityBeforeTheirLength) {
  std::vector<NewJob> new_jobs = sample_jobs(3);  // the last is the longest
  new_jobs[0].priority = 2, new_jobs[1].priority = 1;
  add_sweep(connection, "s", "{}", new_jobs);
  std::vector<std::string> hashes;
  for (const Job& row : next_jobs(connection, std::nullopt, 3)) hashes.push_back(row.hash);
  EXPECT_THAT(hashes, testing::ElementsAre(new_jobs[0].hash, new_jobs[1].hash, new_jobs[2].hash));
}

TEST_F(Jobs, KeepTheirScenes) {
  add_sweep(connection, "s", "{}", sample_jobs(2));
  for (const Job& row : jobs(connection, {}))
    EXPECT_EQ(scene(connection, row.id), R"({"impact": {"v_imp_cm_per_s": )" +
                                             std::to_string(static_cast<int>(row.v_imp_cm_per_s)) +
                                             "}}");
  EXPECT_THROW(scene(connection, 99), Error);
}

TEST_F(Jobs, GoThroughAttemptsToAResult) {
  add_sweep(connection, "s", "{}", sample_jobs(1));
  begin_attempts(connection, std::vector{Start{1, "here", "100", "0.1.0"}});
  EXPECT_EQ(job(1).state, JobState::running);
  end_attempt(connection, 1, ended(ExitReason::crashed), JobState::pending);
  EXPECT_EQ(job(1).state, JobState::pending);
  EXPECT_EQ(job(1).crashes, 1);
  begin_attempts(connection, std::vector{Start{1, "here", "101", "0.1.0"}});
  finish(connection, 1, ended(ExitReason::finished), sample_result(0.24),
         std::vector<Remnant>{Remnant{.rank = 1}, Remnant{.rank = 2}});
  EXPECT_EQ(job(1).state, JobState::done);
  EXPECT_EQ(count("attempts WHERE ended IS NOT NULL"), 2);
  EXPECT_EQ(count("results"), 1);
}

TEST_F(Jobs, StayAsTheyWereWhenTheirResultCannotBeCommitted) {
  add_sweep(connection, "s", "{}", sample_jobs(1));
  begin_attempts(connection, std::vector{Start{1, "here", "100", "0.1.0"}});
  const std::vector<Remnant> two_of_one_rank(2, Remnant{.rank = 1});
  EXPECT_THROW(
      finish(connection, 1, ended(ExitReason::finished), sample_result(0.24), two_of_one_rank),
      Error);
  EXPECT_EQ(job(1).state, JobState::running);
  EXPECT_EQ(count("results"), 0);
  EXPECT_EQ(count("attempts WHERE ended IS NULL"), 1);
}

TEST_F(Jobs, FinishedTwiceHaveOneResult) {
  add_sweep(connection, "s", "{}", sample_jobs(1));
  finish(connection, 1, ended(ExitReason::finished), sample_result(0.24), {});
  finish(connection, 1, ended(ExitReason::finished), sample_result(0.25), {});
  EXPECT_EQ(count("results"), 1);
}

TEST_F(Jobs, ThatFailedAreTriedAgainOnRequestWithACleanSlate) {
  const AddedSweep sweep = add_sweep(connection, "s", "{}", sample_jobs(2));
  begin_attempts(connection, std::vector{Start{1, "here", "100", "0.1.0"}});
  end_attempt(connection, 1, ended(ExitReason::crashed), JobState::failed);
  EXPECT_EQ(retry_failed(connection, sweep.sweep + 1), 0u);
  EXPECT_EQ(retry_failed(connection, sweep.sweep), 1u);
  EXPECT_EQ(job(1).state, JobState::pending);
  EXPECT_EQ(job(1).crashes, 0);
}

/// Work that grew with the square would take hours here.
TEST_F(Jobs, OfAHundredThousandAreAddedAndCounted) {
  add_sweep(connection, "large", "{}", sample_jobs(100'000));
  EXPECT_EQ(sweep_status(connection).at(0).jobs.at(JobState::pending), 100'000);
}

}  // namespace
}  // namespace eerie::db
