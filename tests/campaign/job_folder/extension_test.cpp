#include "campaign/job_folder/extension.hpp"

#include <gmock/gmock.h>

#include "solver/base/error.hpp"
#include "solver/run/checkpoints.hpp"
#include "tests/campaign/job_folder/job_files.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/scenes.hpp"

namespace eerie::job_folder {
namespace {
using testing::HasSubstr;
using testing::ThrowsMessage;
namespace fs = std::filesystem;

/// A job directory with a result of this end, and a state from before it.
class Extension : public testing::Test {
 protected:
  void end_as(run::EndReason reason, const nlohmann::json& end, bool has_state = true) {
    nlohmann::json document = to_json(test::random_snapshot(300).scene);
    document.merge_patch({{"end", end}, {"output", {{"snapshot_interval_s", 1000}}}});
    scene = parse_scene(document);
    run::RunSummary summary = test::sample_summary(scene);
    summary.reason = reason;
    summary.progress.time = 5000;
    fs::create_directories(finished.path);
    install_text(finished.result(), result_json(scene, summary, test::sample_analysis()).dump());
    fs::remove(finished.path / run::before_end_file);
    if (!has_state) return;
    io::Snapshot state = test::random_snapshot(300);
    state.scene = scene;
    state.state.time = 2500;
    io::write_snapshot(finished.path / run::before_end_file, state);
  }
  Scene later(double until_s) { return extended_scene(finished, scene, until_s); }

  test::TemporaryFolder folder;
  JobDirectory finished{folder / "finished"}, longer{folder / "longer"};
  Scene scene = test::small_scene();
};

TEST_F(Extension, MovesTheEndThatTheRunCameTo) {
  end_as(run::EndReason::end_time, {{"time_s", 5000}});
  EXPECT_EQ(later(9000).end.time_s, 9000);
  Scene same = later(9000);
  same.end.time_s = 5000;
  EXPECT_EQ(scene_hash(same), scene_hash(scene));
  end_as(run::EndReason::latest_time, {{"time_s", 3000}, {"latest_s", 5000}});
  EXPECT_EQ(later(9000).end.time_s, 3000);
  EXPECT_EQ(later(9000).end.latest_s, 9000);
  end_as(run::EndReason::end_time, {{"time_s", 3000}, {"latest_s", 7000}});
  EXPECT_EQ(later(9000).end.time_s, 9000);
}

TEST_F(Extension, IsRefusedWithTheReason) {
  const auto refused = [&](double until_s, const char* reason) {
    EXPECT_THAT([&] { later(until_s); }, ThrowsMessage<InputError>(HasSubstr(reason)));
  };
  refused(9000, "result.json is missing");
  end_as(run::EndReason::end_time, {{"time_s", 5000}});
  refused(5000, "its end is at 5000 s; give a later time");
  refused(1e9, "end.time_s = 1000000000");
  end_as(run::EndReason::settled, {{"time_s", 9000}, {"settled", {{"window_s", 800}}}}, false);
  refused(20000, "it had settled at 5000 s, and with a later end it would end there all the same");
  // What had settled because little time was left goes on, past the end that it had.
  end_as(run::EndReason::settled, {{"time_s", 9000}, {"settled", {{"window_s", 800}}}});
  refused(8000, "its end is at 9000 s; give a later time");
  EXPECT_EQ(later(20000).end.time_s, 20000);
  end_as(run::EndReason::end_time, {{"time_s", 5000}}, false);
  refused(9000, "before_end.hdf5 is not there");
  end_as(run::EndReason::end_time, {{"time_s", 5000}});
  io::Snapshot old = io::read_snapshot(finished.path / run::before_end_file);
  old.solver_version = "0.0.1";
  io::write_snapshot(finished.path / run::before_end_file, old);
  refused(9000, "is of solver version 0.0.1");
}

TEST_F(Extension, HasWhatTheRunHadUntilThenAndNothingAfterwards) {
  end_as(run::EndReason::end_time, {{"time_s", 5000}});
  install_text(finished.history(), "time_s,x\n0,1\n2500,2\n3000,3\n");
  for (const long number : {0, 1, 2, 3, 4}) {
    io::Snapshot snapshot = test::random_snapshot(300);
    snapshot.scene = scene;
    io::write_snapshot(run::snapshot_path(finished.path, number), snapshot);
  }
  const Scene until_9000 = later(9000);
  EXPECT_EQ(make_extension(finished, longer, until_9000), 2500);
  EXPECT_EQ(read_file(longer.history()), "time_s,x\n0,1\n2500,2\n");
  EXPECT_FALSE(fs::exists(longer.remnants()));
  EXPECT_TRUE(fs::exists(run::snapshot_path(longer.path, 2)));
  EXPECT_FALSE(fs::exists(run::snapshot_path(longer.path, 3)));
  EXPECT_EQ(scene_hash(io::read_snapshot(longer.first_snapshot()).scene), scene_hash(until_9000));
  const auto ignore = [](const std::string&) {};
  EXPECT_TRUE(run::newest_checkpoint(longer.path, until_9000, ignore));
  // It may have gone on since: that is left alone.
  install_text(longer.history(), "further");
  EXPECT_EQ(make_extension(finished, longer, until_9000), 2500);
  EXPECT_EQ(read_file(longer.history()), "further");
}

}  // namespace
}  // namespace eerie::job_folder
