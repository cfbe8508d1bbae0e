#include "campaign/manager/doctor.hpp"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include <fstream>

#include "campaign/sweeps/job.hpp"
#include "db/jobs/jobs.hpp"
#include "db/views/query.hpp"
#include "tests/campaign/job_folder/job_files.hpp"
#include "tests/db/jobs/sample_jobs.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::manager {
namespace {
using testing::HasSubstr;
namespace fs = std::filesystem;

class Doctor : public testing::Test {
 protected:
  void SetUp() override {
    std::vector<db::NewJob> jobs;
    for (int i = 0; i < 2; ++i) {
      scenes.push_back(parse_scene({{"numerics", {{"seed", i}}}}));
      jobs.push_back(sweeps::new_job(scenes.back()));
    }
    db::add_sweep(connection, "s", "{}", jobs);
  }
  job_folder::JobDirectory directory(int scene) {
    return job_folder::job_folder(connection)
        .of(scene_hash(scenes.at(static_cast<std::size_t>(scene))));
  }
  void start(std::int64_t job) {
    db::begin_attempts(connection, std::vector{db::Start{job, "here", "1", "0.1.0"}});
  }
  /// Job 1 done, with its result in its directory.
  void finish_first() {
    test::install_result(directory(0), scenes[0]);
    start(1);
    const auto stored = job_folder::read_result(directory(0), scene_hash(scenes[0]));
    db::finish(connection, 1, test::ended(db::ExitReason::finished), stored->result,
               stored->remnants);
  }
  std::vector<Problem> examined() {
    return examine(connection, [](std::size_t, std::size_t) {});
  }
  /// Mends and expects that nothing is left that a program could mend.
  std::vector<Problem> mended() {
    auto findings = mend(connection, [](std::size_t, std::size_t) {});
    for (const Problem& f : examined()) EXPECT_FALSE(f.mendable) << f.what;
    return findings;
  }
  db::JobState state(std::size_t job) { return db::jobs(connection, {}).at(job).state; }

  test::TemporaryFolder folder;
  db::Connection connection{folder / "a.sqlite", db::Access::write};
  std::vector<Scene> scenes;
};

TEST_F(Doctor, FindsNothingInAHealthyCampaign) {
  finish_first();
  EXPECT_TRUE(examined().empty());
}

TEST_F(Doctor, MakesViewsAnewThatSomebodyHasChangedOrRemoved) {
  finish_first();
  connection.write([](SQLite::Database& sql) {
    sql.exec("DROP VIEW results; CREATE VIEW results AS SELECT 1 AS x; DROP VIEW maps");
  });
  ASSERT_EQ(examined().size(), 1u);
  EXPECT_THAT(examined()[0].what, HasSubstr("changed or removed the views maps, results"));
  EXPECT_EQ(mended().size(), 1u);
  EXPECT_TRUE(examined().empty());
  EXPECT_EQ(db::results(connection, {}).size(), 1u);
}

TEST_F(Doctor, TakesAResultThatTheDatabaseDoesNotKnow) {
  test::install_result(directory(0), scenes[0]);
  ASSERT_EQ(examined().size(), 1u);
  EXPECT_EQ(db::results(connection, {}).size(), 0u) << "looking changes nothing";
  const auto findings = mended();
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_TRUE(findings[0].mended);
  EXPECT_EQ(db::results(connection, {}).size(), 1u);
}

TEST_F(Doctor, LetsGoOfAJobWhoseWorkerIsGone) {
  start(1);
  start(2);
  test::install_result(directory(1), scenes[1]);
  ASSERT_EQ(mended().size(), 2u);
  EXPECT_EQ(db::count_jobs(connection, std::nullopt)[db::JobState::pending], 1u);
  EXPECT_EQ(db::count_jobs(connection, std::nullopt)[db::JobState::done], 1u);
}

TEST_F(Doctor, ReportsADamagedResultFileAndKeepsTheRow) {
  finish_first();
  std::ofstream(directory(0).result()) << "{";
  const auto findings = mended();
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_FALSE(findings[0].mended);
  EXPECT_THAT(findings[0].what, HasSubstr("result.json is missing or damaged"));
  EXPECT_EQ(db::results(connection, {}).size(), 1u);
}

TEST_F(Doctor, TakesTheFilesNumbersWhereTheDatabaseHasOthers) {
  finish_first();
  connection.write(
      [](SQLite::Database& sql) { sql.exec("UPDATE job_results SET b_over_a = 0.9"); });
  ASSERT_EQ(mended().size(), 1u);
  EXPECT_NE(db::results(connection, {}).at(0).result.b_over_a, 0.9);
}

TEST_F(Doctor, RemovesHalfWrittenFilesAndDamagedCheckpoints) {
  fs::create_directories(directory(0).path);
  std::ofstream(directory(0).path / ".result.json.77.tmp") << "{\"ver";
  std::ofstream(directory(0).checkpoint()) << "no HDF5";
  EXPECT_EQ(mended().size(), 2u);
  EXPECT_TRUE(fs::is_empty(directory(0).path));
}

TEST_F(Doctor, ReportsADirectoryOfNoJob) {
  fs::create_directories(job_folder::job_folder(connection).root / "0123456789abcdef");
  const auto findings = mended();
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_THAT(findings[0].what, HasSubstr("belongs to no job"));
}

TEST_F(Doctor, ClosesAttemptsThatWereLeftOpen) {
  finish_first();
  connection.write([](SQLite::Database& sql) { sql.exec("UPDATE attempts SET ended = NULL"); });
  ASSERT_EQ(mended().size(), 1u);
}

TEST_F(Doctor, ReportsAReferenceThatLeadsNowhere) {
  SQLite::Database raw(folder / "a.sqlite", SQLite::OPEN_READWRITE);
  raw.exec("PRAGMA foreign_keys = OFF; DELETE FROM jobs WHERE id = 2");
  const auto findings = examined();
  ASSERT_FALSE(findings.empty());
  EXPECT_THAT(findings[0].what, HasSubstr("names a row of jobs that is not there"));
}

}  // namespace
}  // namespace eerie::manager
