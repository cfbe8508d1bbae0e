#include "campaign/worker/reanalysis.hpp"

#include <gmock/gmock.h>

#include "campaign/job_folder/result_file.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/worker/worker.hpp"
#include "db/jobs/jobs.hpp"
#include "db/views/query.hpp"
#include "solver/base/file.hpp"
#include "tests/db/jobs/sample_jobs.hpp"
#include "tests/run/runs.hpp"

namespace eerie::worker {
namespace {
namespace fs = std::filesystem;

/// A finished job whose result tells no details, as one of an older program.
class ReanalysisTest : public testing::Test {
 protected:
  void SetUp() override {
    const db::NewJob job = sweeps::new_job(scene);
    add_sweep(connection, "s", "{}", std::vector{job});
    directory = job_folder::job_folder(connection).of(job.hash);
    fs::create_directories(directory.path);
    const Computed computed = compute(scene, directory.path, 1, 0, {});
    remnants::Analysis plain = computed.analysis;
    shape_class = shapes::name(plain.details.front().shape_class);
    plain.details.clear();
    install_text(directory.result(),
                 job_folder::result_json(scene, computed.summary, plain).dump());
    const auto stored = job_folder::read_result(directory, job.hash);
    db::begin_attempts(connection, std::vector{db::Start{1, "here", "1", "0.1.0"}});
    db::finish(connection, 1, test::ended(db::ExitReason::finished), stored->result,
               stored->remnants);
  }

  test::TemporaryFolder folder;
  Scene scene = test::short_impact();
  db::Connection connection{folder / "a.sqlite", db::Access::write};
  job_folder::JobDirectory directory;
  std::string shape_class;  ///< as an analysis at the end of the run has it
};

TEST_F(ReanalysisTest, TellsWhatTheOlderAnalysisDidNot) {
  const db::Remnant before = db::remnants(connection, 1).front();
  const db::ResultRow result = db::results(connection, {}).front();
  ASSERT_EQ(before.shape_class, "");
  const Reanalysis report = reanalyse(connection, [](std::size_t, std::size_t) {});
  EXPECT_EQ(report.analysed, 1u);
  EXPECT_THAT(report.skipped, testing::IsEmpty());
  const db::Remnant after = db::remnants(connection, 1).front();
  EXPECT_EQ(after.shape_class, shape_class);
  EXPECT_TRUE(after.details[1]);
  EXPECT_NEAR(*after.b_over_a, *before.b_over_a, 1e-6);
  const db::ResultRow again = db::results(connection, {}).front();
  EXPECT_EQ(again.finished, result.finished);
  EXPECT_EQ(again.result.steps, result.result.steps);
  EXPECT_EQ(again.result.outcome_class, result.result.outcome_class);
  const auto file = job_folder::read_result(directory, scene_hash(scene));
  ASSERT_TRUE(file);
  EXPECT_EQ(file->remnants.front().shape_class, shape_class);
}

TEST_F(ReanalysisTest, LeavesAResultAloneWhoseSnapshotIsGone) {
  const std::string before = read_file(directory.result());
  fs::remove(directory.final_snapshot());
  const Reanalysis report = reanalyse(connection, [](std::size_t, std::size_t) {});
  EXPECT_EQ(report.analysed, 0u);
  ASSERT_EQ(report.skipped.size(), 1u);
  EXPECT_THAT(report.skipped[0], testing::HasSubstr("final.hdf5"));
  EXPECT_EQ(read_file(directory.result()), before);
}

TEST_F(ReanalysisTest, DoesWithoutDepthsWhereTheFirstSnapshotIsDamaged) {
  install_text(directory.first_snapshot(), "torn");
  EXPECT_EQ(reanalyse(connection, [](std::size_t, std::size_t) {}).analysed, 1u);
  const db::Remnant after = db::remnants(connection, 1).front();
  EXPECT_EQ(after.shape_class, shape_class);
  EXPECT_FALSE(after.details[10]) << db::remnant_detail_columns[10];
}

}  // namespace
}  // namespace eerie::worker
