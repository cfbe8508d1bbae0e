#include "db/jobs/merge.hpp"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include "db/jobs/control.hpp"
#include "db/store/row_copy.hpp"
#include "db/store/settings.hpp"
#include "db/views/query.hpp"
#include "tests/db/jobs/sample_jobs.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::db {
namespace {
using test::ended;
using test::sample_jobs;
using test::sample_result;
using testing::ElementsAre;
using testing::IsEmpty;

class Merging : public testing::Test {
 protected:
  /// Adds jobs `first` to `last` of the samples, as a sweep of that name.
  static void add(Connection& to, const std::string& name, std::size_t first, std::size_t last) {
    std::vector<NewJob> all = sample_jobs(static_cast<int>(last) + 1);
    add_sweep(to, name, "{}", std::span(all).subspan(first));
  }
  static Job job(const Connection& in, int number) {
    const std::string hash = "hash-" + std::to_string(number);
    for (const Job& row : jobs(in, {}))
      if (row.hash == hash) return row;
    ADD_FAILURE() << "no " << hash;
    return {};
  }
  static void start(Connection& in, int number) {
    begin_attempts(in, std::vector{Start{job(in, number).id, "here", "1", "0.1.0"}});
  }
  static void done(Connection& in, int number, double b_over_a, const char* version = "0.1.0") {
    start(in, number);
    Result result = sample_result(b_over_a);
    result.solver_version = version;
    const Remnant remnant{.rank = 1, .mass_over_total = 0.97, .b_over_a = b_over_a};
    finish(in, job(in, number).id, ended(ExitReason::finished), result, std::vector{remnant});
  }
  Merged put_theirs_into_ours() {
    Merged merged;
    ours.write([&](SQLite::Database& to) {
      theirs.read([&](SQLite::Database& from) { merged = merge(from, to); });
    });
    return merged;
  }
  static int number(const Connection& in, const char* sql) {
    int value = 0;
    in.read([&](SQLite::Database& database) { value = database.execAndGet(sql).getInt(); });
    return value;
  }
  std::optional<double> b_over_a(int of) {
    for (const ResultRow& row : results(ours, {}))
      if (row.hash == "hash-" + std::to_string(of)) return row.result.b_over_a;
    return std::nullopt;
  }

  test::TemporaryFolder folder;
  Connection ours{folder / "ours.sqlite", Access::write};
  Connection theirs{folder / "theirs.sqlite", Access::write};
};

TEST_F(Merging, TakesWhatIsMissingAndDoublesNothingHoweverOftenItIsDone) {
  add(ours, "first", 0, 1), add(theirs, "second", 1, 2);
  done(ours, 0, 0.5), done(theirs, 1, 0.25), done(theirs, 2, 0.75);
  const Merged merged = put_theirs_into_ours();
  EXPECT_EQ(merged.jobs, 2u);
  EXPECT_EQ(merged.added, 1u);
  EXPECT_EQ(merged.results, 2u);
  EXPECT_EQ(merged.attempts, 2u);
  EXPECT_THAT(merged.taken, ElementsAre("hash-1", "hash-2"));
  for (int time = 0; time < 2; ++time) {
    EXPECT_EQ(number(ours, "SELECT count(*) FROM jobs"), 3);
    EXPECT_EQ(number(ours, "SELECT count(*) FROM results"), 3);
    EXPECT_EQ(number(ours, "SELECT count(*) FROM remnants"), 3);
    EXPECT_EQ(number(ours, "SELECT count(*) FROM attempts"), 3);
    EXPECT_EQ(number(ours, "SELECT count(*) FROM sweeps"), 2);
    EXPECT_EQ(number(ours, "SELECT count(*) FROM sweep_jobs"), 4);
    EXPECT_EQ(number(ours, "SELECT count(*) FROM jobs WHERE settings IS NULL"), 0);
    EXPECT_EQ(number(ours, "SELECT count(*) FROM job_settings"), 1);
    EXPECT_EQ(job(ours, 1).state, JobState::done);
    EXPECT_EQ(b_over_a(1), 0.25);
    const Merged again = put_theirs_into_ours();
    EXPECT_EQ(again.added + again.results + again.attempts, 0u);
    EXPECT_THAT(again.taken, IsEmpty());
  }
}

TEST_F(Merging, TakesEveryColumnThatATableHas) {
  add(theirs, "s", 0, 0);
  done(theirs, 0, 0.25);
  put_theirs_into_ours();
  for (const char* table :
       {"jobs", "job_scenes", "job_results", "job_remnants", "attempts", "job_settings"}) {
    const auto rows = [&](const Connection& in) {
      std::string text;
      in.read([&](SQLite::Database& sql) {
        SQLite::Statement select(sql, std::string("SELECT * FROM ") + table);
        while (select.executeStep())
          for (int k = 0; k < select.getColumnCount(); ++k)
            text += select.getColumn(k).getString() + "|";
      });
      return text;
    };
    EXPECT_EQ(rows(ours), rows(theirs)) << table;
    EXPECT_NE(rows(ours), "") << table;
  }
}

TEST_F(Merging, OfTwoResultsTakesThatOfTheNewerSolver) {
  for (Connection* one : {&ours, &theirs}) add(*one, "s", 0, 1);
  done(ours, 0, 0.5, "0.9.0"), done(theirs, 0, 0.25, "0.10.0");
  done(ours, 1, 0.5, "0.10.0"), done(theirs, 1, 0.25, "0.9.0");
  set(ours, "solver_version", "0.9.0"), set(theirs, "solver_version", "0.10.0");
  EXPECT_THAT(put_theirs_into_ours().taken, ElementsAre("hash-0"));
  EXPECT_EQ(b_over_a(0), 0.25);
  EXPECT_EQ(b_over_a(1), 0.5);
  EXPECT_EQ(number(ours, "SELECT count(*) FROM remnants"), 2);
  EXPECT_EQ(setting(ours, "solver_version"), "0.10.0");
  EXPECT_EQ(number(ours, "SELECT sum(stale) FROM results"), 0);
}

TEST_F(Merging, KeepsItsOwnResultWhereThatOfTheSameSolverDiffersAndSaysSo) {
  for (Connection* one : {&ours, &theirs}) add(*one, "s", 0, 1), done(*one, 1, 0.6);
  done(ours, 0, 0.5), done(theirs, 0, 0.25);
  const Merged merged = put_theirs_into_ours();
  EXPECT_THAT(merged.differing, ElementsAre("hash-0"));
  EXPECT_THAT(merged.taken, IsEmpty());
  EXPECT_EQ(b_over_a(0), 0.5);
}

TEST_F(Merging, MakesPendingWhatTheOthersManagerRunsAndLeavesOutItsOpenAttempt) {
  add(theirs, "s", 0, 2);
  start(theirs, 0), start(theirs, 1);
  theirs.write([](SQLite::Database& sql) { cancel(sql, {.v_imp_cm_per_s = Range{16, 16}}); });
  put_theirs_into_ours();
  EXPECT_EQ(job(ours, 0).state, JobState::pending);
  EXPECT_EQ(job(ours, 1).state, JobState::cancelled);
  EXPECT_EQ(number(ours, "SELECT count(*) FROM jobs WHERE wanted <> 'run'"), 0);
  EXPECT_EQ(number(ours, "SELECT count(*) FROM attempts"), 0);
}

TEST_F(Merging, LearnsOfAFailureWhereItHasNotTriedItself) {
  for (Connection* one : {&ours, &theirs}) add(*one, "s", 0, 1);
  start(theirs, 0);
  end_attempt(theirs, job(theirs, 0).id, ended(ExitReason::failed), JobState::failed);
  start(ours, 1), start(theirs, 1);
  end_attempt(ours, job(ours, 1).id, ended(ExitReason::stopped), JobState::pending);
  end_attempt(theirs, job(theirs, 1).id, ended(ExitReason::failed), JobState::failed);
  EXPECT_THAT(put_theirs_into_ours().taken, ElementsAre("hash-0"));
  EXPECT_EQ(job(ours, 0).state, JobState::failed);
  EXPECT_EQ(job(ours, 1).state, JobState::pending);
}

TEST_F(Merging, TakesRequestsSoThatNoneIsCarriedOutAgain) {
  int carried_out = 0;
  const auto ask = [&](Connection& in) {
    once(in, "id-1", "pause", [&](auto&) { return ++carried_out, std::string("{}"); });
  };
  ask(theirs);
  put_theirs_into_ours();
  ask(ours);
  EXPECT_EQ(carried_out, 1);
}

}  // namespace
}  // namespace eerie::db
