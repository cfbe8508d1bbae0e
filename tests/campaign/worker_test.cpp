#include "campaign/worker.hpp"

#include <gtest/gtest.h>

#include "campaign/result_file.hpp"
#include "solver/base/file.hpp"
#include "tests/step/runs.hpp"

namespace eerie {
namespace {
namespace fs = std::filesystem;

TEST(Worker, BringsItsJobToAResultAndRemovesItsCheckpoints) {
  const test::TemporaryFolder folder;
  const JobDirectory directory{folder.path()};
  const Scene scene = test::short_impact({{"output", {{"checkpoint_interval_s", 0}}}});
  install_text(directory.scene(), to_json(scene).dump());
  // An earlier attempt leaves both checkpoints.
  compute(scene, directory.path, 1, 40, {});
  ASSERT_TRUE(fs::exists(directory.checkpoint()) && fs::exists(directory.previous_checkpoint()));
  WorkerOptions options;
  options.directory = directory.path;
  EXPECT_EQ(run_worker(options), 0);
  EXPECT_TRUE(read_result(directory, scene_hash(scene)));
  EXPECT_TRUE(fs::exists(directory.heartbeat()));
  EXPECT_FALSE(fs::exists(directory.checkpoint()));
  EXPECT_FALSE(fs::exists(directory.previous_checkpoint()));
}

}  // namespace
}  // namespace eerie
