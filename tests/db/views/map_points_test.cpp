#include "db/views/map_points.hpp"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include "analysis/statistics/ensemble.hpp"
#include "db/jobs/job_settings.hpp"
#include "db/jobs/jobs.hpp"
#include "db/store/settings.hpp"
#include "tests/db/jobs/sample_jobs.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::db {
namespace {
using test::ended;
using test::sample_result;
using testing::ElementsAre;
using testing::Pair;

std::optional<double> mean(const std::vector<double>& numbers) {
  return statistics::mean_of(statistics::ensemble(numbers));
}
std::optional<double> std_dev(const std::vector<double>& numbers) {
  return statistics::deviation_of(statistics::ensemble(numbers));
}

/// One job more than before, which differs from others of `settings` in speed and seed only.
class MapPoints : public testing::Test {
 protected:
  std::int64_t add(double v, int seed, const std::string& settings = "") {
    NewJob job = test::sample_jobs(1)[0];
    job.hash = "hash-" + std::to_string(++jobs_);
    job.scene = R"({"impact": {"v_imp_cm_per_s": )" + std::to_string(v) +
                R"(}, "numerics": {"seed": )" + std::to_string(seed) + R"(, "scheme": ")" +
                settings + R"("}})";
    job.v_imp_cm_per_s = v, job.seed = seed, job.fidelity = settings;
    add_sweep(connection, "s", "{}", std::vector{job});
    return jobs_;
  }
  void finish_with(std::int64_t job, const Result& result) {
    finish(connection, job, ended(ExitReason::finished), result, {});
  }
  static Result of_class(double b_over_a, const char* name) {
    Result result = sample_result(b_over_a);
    result.outcome_class = name;
    return result;
  }
  /// A number of the view `maps` at the only place that has this speed.
  double in_view(const std::string& column, double v) {
    double value = 0;
    connection.read([&](SQLite::Database& sql) {
      value = sql.execAndGet("SELECT " + column +
                             " FROM maps WHERE v_imp_cm_per_s = " + std::to_string(v))
                  .getDouble();
    });
    return value;
  }

  test::TemporaryFolder folder;
  Connection connection{folder / "a.sqlite", Access::write};
  std::int64_t jobs_ = 0;
};

TEST_F(MapPoints, HoldEveryPlaceWhateverItsState) {
  finish_with(add(15, 1), sample_result(0.2));
  end_attempt(connection, add(16, 1), ended(ExitReason::failed), JobState::failed);
  add(17, 1);
  const std::vector<MapPoint> points = map_points(connection, {});
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(mean(points[0].b_over_a), 0.2);
  EXPECT_EQ(points[0].outcome_class(), "perfect-merging");
  EXPECT_EQ(points[1].failed, 1);
  EXPECT_EQ(points[1].results, 0);
  EXPECT_EQ(points[2].jobs, 1);
  EXPECT_EQ(points[2].done, 0);
  EXPECT_EQ(mean(points[2].b_over_a), std::nullopt);
  EXPECT_EQ(points[2].outcome_class(), "");
}

TEST_F(MapPoints, AreMeansAndDeviationsOverSeeds) {
  const double shapes[] = {0.25, 0.35, 0.45};
  for (int seed = 1; seed <= 3; ++seed) finish_with(add(15, seed), sample_result(shapes[seed - 1]));
  const MapPoint point = map_points(connection, {}).at(0);
  EXPECT_EQ(point.jobs, 3);
  EXPECT_DOUBLE_EQ(mean(point.b_over_a).value(), 0.35);
  EXPECT_DOUBLE_EQ(std_dev(point.b_over_a).value(), 0.1);
  EXPECT_EQ(std_dev(point.period_h), 0);
  EXPECT_DOUBLE_EQ(point.p_largest_eer(), 1.0 / 3);
  EXPECT_DOUBLE_EQ(in_view("b_over_a", 15), 0.35);
  EXPECT_NEAR(in_view("b_over_a_std", 15), 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(in_view("p_eer", 15), 1.0 / 3);
}

TEST_F(MapPoints, LeaveOutWhatAResultDoesNotHave) {
  Result still = sample_result(0.5), shapeless = sample_result(0.5);
  still.period_h.reset();
  shapeless.b_over_a.reset();
  finish_with(add(15, 1), still);
  finish_with(add(15, 2), shapeless);
  const MapPoint point = map_points(connection, {}).at(0);
  EXPECT_EQ(point.results, 2);
  EXPECT_EQ(point.b_over_a.size(), 1u);
  EXPECT_EQ(mean(point.b_over_a), 0.5);
  EXPECT_EQ(std_dev(point.b_over_a), std::nullopt);
  EXPECT_EQ(mean(point.period_h), 9.36);
}

TEST_F(MapPoints, CountEersOfTheLargestRemnantApartFromSmallerOnes) {
  Result smaller = sample_result(0.5), both = sample_result(0.2);
  smaller.n_eer = 1;
  both.n_eer = 2;
  finish_with(add(15, 1), smaller);
  finish_with(add(15, 2), both);
  finish_with(add(15, 3), sample_result(0.2));
  const MapPoint point = map_points(connection, {}).at(0);
  EXPECT_EQ(point.largest_is_eer, 2);
  EXPECT_EQ(point.smaller_is_eer, 2);
  EXPECT_DOUBLE_EQ(mean(point.n_eer).value(), 4.0 / 3);
}

TEST_F(MapPoints, AreOfTheMostFrequentClassAndOfEqualsTheFirstByName) {
  for (const auto& [v, names] :
       {std::pair(15, std::vector{"hit-and-run", "erosion", "hit-and-run"}),
        std::pair(16, std::vector{"hit-and-run", "erosion"})})
    for (std::size_t k = 0; k < names.size(); ++k)
      finish_with(add(v, static_cast<int>(k) + 1), of_class(0.5, names[k]));
  const std::vector<MapPoint> points = map_points(connection, {});
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].outcome_class(), "hit-and-run");
  EXPECT_THAT(points[0].classes, ElementsAre(Pair("erosion", 1), Pair("hit-and-run", 2)));
  EXPECT_EQ(points[1].outcome_class(), "erosion");
  EXPECT_EQ(in_view("class = 'hit-and-run'", 15), 1);
  EXPECT_DOUBLE_EQ(in_view("class_share", 15), 2.0 / 3);
  EXPECT_EQ(in_view("class = 'erosion'", 16), 1);
}

TEST_F(MapPoints, CountResultsOfOtherSolverVersions) {
  set(connection, "solver_version", "0.2.0");
  Result now = sample_result(0.4);
  now.solver_version = "0.2.0";
  finish_with(add(15, 1), sample_result(0.2));
  finish_with(add(15, 2), now);
  const MapPoint point = map_points(connection, {}).at(0);
  EXPECT_EQ(point.results, 2);
  EXPECT_EQ(point.stale, 1);
}

TEST_F(MapPoints, DoNotMixSettingsOfTheSameParticleNumber) {
  finish_with(add(15, 1, "coarse"), sample_result(0.2));
  finish_with(add(15, 2, "coarse"), sample_result(0.4));
  finish_with(add(15, 1, "fine"), sample_result(0.8));
  add(16, 1, "coarse");
  const std::vector<MapPoint> points = map_points(connection, {});
  ASSERT_EQ(points.size(), 3u);  // by settings, then by speed
  EXPECT_DOUBLE_EQ(mean(points[0].b_over_a).value(), 0.3);
  EXPECT_EQ(points[0].settings, points[1].settings);
  EXPECT_EQ(points[1].v_imp_cm_per_s, 16);
  EXPECT_EQ(mean(points[2].b_over_a), 0.8);
  EXPECT_NE(points[2].settings, points[0].settings);
  EXPECT_EQ(map_points(connection, {.fidelity = "fine"}).size(), 1u);
  EXPECT_EQ(map_points(connection, {.settings = points[0].settings}).size(), 2u);
  connection.read([](SQLite::Database& sql) {
    EXPECT_EQ(sql.execAndGet("SELECT count(*) FROM maps WHERE v_imp_cm_per_s = 15").getInt(), 2);
    EXPECT_EQ(sql.execAndGet("SELECT b_over_a FROM maps WHERE fidelity = 'fine'").getDouble(), 0.8);
    EXPECT_EQ(sql.execAndGet("SELECT count(DISTINCT settings) FROM results").getInt(), 2);
  });
}

TEST_F(MapPoints, NameWhatJobsOfTheSameSettingsShare) {
  add(15, 1, "coarse");
  add(15, 1, "fine");
  add(16, 2, "fine");
  const std::vector<JobSettings> all = job_settings(connection);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[1].fidelity, "fine");
  EXPECT_EQ(all[1].scene, R"({"impact":{},"numerics":{"scheme":"fine"}})");
}

TEST(JobSettings, AreCountedBeforeJobsAreInADatabase) {
  std::vector<NewJob> jobs = test::sample_jobs(3);
  EXPECT_EQ(count_settings(jobs), 1u);
  jobs[1].scene = R"({"numerics": {"scheme": "other"}})";
  EXPECT_EQ(count_settings(jobs), 2u);
}

}  // namespace
}  // namespace eerie::db
