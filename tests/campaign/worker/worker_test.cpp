#include "campaign/worker/worker.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace eerie::worker
