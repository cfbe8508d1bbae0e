#include "db/views/query.hpp"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include "db/jobs/jobs.hpp"
#include "tests/db/jobs/sample_jobs.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::db {
namespace {
using test::ended;
using test::sample_jobs;
using test::sample_result;

/// Five jobs, v = 15 to 19: b/a 0.2, 0.3, 0.4 done, one failed, one pending.
class Query : public testing::Test {
 protected:
  Query() {
    sweep = add_sweep(connection, "s", "{}", sample_jobs(5)).sweep;
    for (const Job& job : jobs(connection, {})) {
      const double v = job.v_imp_cm_per_s;
      if (v > 18) continue;
      begin_attempts(connection, std::vector{Start{job.id, "here", "1", "0.1.0"}});
      AttemptEnd failure = ended(ExitReason::failed);
      failure.failure_kind = "not-finite";
      failure.message = "particle 7";
      if (v == 18)
        end_attempt(connection, job.id, failure, JobState::failed);
      else
        finish(connection, job.id, ended(ExitReason::finished), sample_result(0.2 + (v - 15) / 10),
               std::vector<Remnant>{Remnant{.rank = 1, .eer = v == 15}});
    }
  }
  std::vector<double> speeds(const ResultFilter& filter) {
    std::vector<double> found;
    for (const ResultRow& row : results(connection, filter)) found.push_back(row.v_imp_cm_per_s);
    return found;
  }

  test::TemporaryFolder folder;
  Connection connection{folder / "a.sqlite", Access::write};
  std::int64_t sweep = 0;
};

TEST_F(Query, FindsResultsByEveryCondition) {
  using testing::ElementsAre;
  using testing::IsEmpty;
  EXPECT_THAT(speeds({}), ElementsAre(15, 16, 17));
  EXPECT_THAT(speeds({.v_imp_cm_per_s = Range{16, 17}}), ElementsAre(16, 17));
  EXPECT_THAT(speeds({.theta_imp_deg = Range{20, 30}}), IsEmpty());
  EXPECT_THAT(speeds({.q = 1.0, .phi_d_deg = 40.0}), ElementsAre(15, 16, 17));
  EXPECT_THAT(speeds({.phi_d_deg = 50.0}), IsEmpty());
  EXPECT_THAT(speeds({.outcome_class = "perfect-merging"}), ElementsAre(15, 16, 17));
  EXPECT_THAT(speeds({.outcome_class = "hit-and-run"}), IsEmpty());
  EXPECT_THAT(speeds({.eer_only = true}), ElementsAre(15));
  EXPECT_THAT(speeds({.sweep = sweep}), ElementsAre(15, 16, 17));
  EXPECT_THAT(speeds({.sweep = sweep + 1}), IsEmpty());
}

TEST_F(Query, GivesBackWhatWasCommitted) {
  const ResultRow row = results(connection, {.v_imp_cm_per_s = Range{15, 15}}).at(0);
  const Result expected = sample_result(0.2);
  EXPECT_EQ(row.result.outcome_class, expected.outcome_class);
  EXPECT_EQ(row.result.b_over_a, expected.b_over_a);
  EXPECT_EQ(row.result.period_h, expected.period_h);
  EXPECT_EQ(row.result.dL_over_L, std::nullopt);
  EXPECT_EQ(row.result.particle_steps, expected.particle_steps);
  EXPECT_TRUE(row.result.eer);
  EXPECT_EQ(row.hash, "hash-0");
}

TEST_F(Query, CountsJobsByStateAndTheWorkLeft) {
  const SweepStatus status = sweep_status(connection).at(0);
  EXPECT_EQ(status.jobs.at(JobState::done), 3);
  EXPECT_EQ(status.jobs.at(JobState::failed), 1);
  EXPECT_EQ(status.jobs.at(JobState::pending), 1);
  EXPECT_EQ(status.particle_steps_left, 1e6 + 4);
}

TEST_F(Query, GroupsFailuresByCause) {
  const std::vector<FailureGroup> groups = failures(connection);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].kind, "not-finite");
  EXPECT_EQ(groups[0].jobs, 1);
  EXPECT_EQ(groups[0].example_message, "particle 7");
  EXPECT_EQ(failures(connection, sweep + 1).size(), 0u);
}

TEST_F(Query, MeasuresSpeedOverFinishedAttempts) {
  const Speed measured = speed(connection);
  EXPECT_DOUBLE_EQ(measured.core_seconds, 9);
  EXPECT_DOUBLE_EQ(measured.particle_steps, 6e6);
  EXPECT_NEAR(measured.expected_over_done, 0.5, 1e-5);
}

TEST_F(Query, AddsUpTheCostOfAttemptsUnlessOneWasLost) {
  const std::int64_t pending = jobs(connection, {std::nullopt, JobState::pending}).at(0).id;
  const auto attempt = [&](std::optional<double> cost) {
    begin_attempts(connection, std::vector{Start{pending, "here", "1", "0.1.0"}});
    AttemptEnd end = ended(cost ? ExitReason::stopped : ExitReason::lost);
    end.core_seconds = cost;
    end_attempt(connection, pending, end, JobState::pending);
  };
  EXPECT_EQ(core_seconds(connection, pending), std::nullopt);
  attempt(2), attempt(3);
  EXPECT_EQ(core_seconds(connection, pending), 5);
  attempt({});
  EXPECT_EQ(core_seconds(connection, pending), std::nullopt);
}

TEST_F(Query, KnowsWhenTheNewestResultCame) {
  const double now =
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  EXPECT_NEAR(newest_result(connection, sweep), now, 60);
  EXPECT_EQ(newest_result(connection, sweep + 1), 0);
}

}  // namespace
}  // namespace eerie::db
