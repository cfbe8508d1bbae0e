#include "campaign/worker/worker.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "campaign/job_folder/result_file.hpp"
#include "solver/base/file.hpp"
#include "tests/run/runs.hpp"

namespace eerie::worker {
namespace {
namespace fs = std::filesystem;

TEST(Worker, BringsItsJobToAResultAndRemovesItsCheckpoints) {
  const test::TemporaryFolder folder;
  const job_folder::JobDirectory directory{folder.path()};
  const Scene scene = test::short_impact({{"output", {{"checkpoint_interval_s", 0}}}});
  install_text(directory.scene(), to_json(scene).dump());
  // An earlier attempt leaves both checkpoints.
  for (int k = 0; k < 1000 && !fs::exists(directory.previous_checkpoint()); ++k)
    compute(scene, directory.path, 1, 40, {});
  ASSERT_TRUE(fs::exists(directory.checkpoint()) && fs::exists(directory.previous_checkpoint()));
  WorkerOptions options;
  options.directory = directory.path;
  EXPECT_EQ(run_worker(options), 0);
  EXPECT_TRUE(job_folder::read_result(directory, scene_hash(scene)));
  EXPECT_TRUE(fs::exists(directory.heartbeat()));
  EXPECT_FALSE(fs::exists(directory.checkpoint()));
  EXPECT_FALSE(fs::exists(directory.previous_checkpoint()));
}

TEST(Worker, EndsEarlyAboutAPrimaryOnlyWithASingleRemnantLeft) {
  // Two bodies that scratch each other and part.
  nlohmann::json scratch = {
      {"impact", {{"v_imp_cm_per_s", 60}, {"theta_imp_deg", 70}}},
      {"end", {{"time_s", 2500}, {"settled", {{"window_s", 400}, {"shape", 0.5}, {"spin", 1}}}}}};
  const auto end_of = [](const nlohmann::json& changes) {
    const test::TemporaryFolder folder;
    return compute(test::short_impact(changes), folder.path(), 1, 0, {});
  };
  const Computed alone = end_of(scratch);
  EXPECT_EQ(alone.summary.reason, run::EndReason::settled);
  EXPECT_LT(alone.summary.progress.time, 2000);
  EXPECT_TRUE(alone.analysis.settled);

  scratch["environment"]["primary"] = {{"mass_kg", 1e6}, {"radius_m", 10}, {"distance_m", 1e6}};
  const Computed about = end_of(scratch);
  EXPECT_EQ(about.summary.reason, run::EndReason::end_time);
  EXPECT_THAT(about.analysis.unsettled_reason,
              testing::HasSubstr("2 remnants go about the primary"));
}

}  // namespace
}  // namespace eerie::worker
