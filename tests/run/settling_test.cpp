#include <gmock/gmock.h>

#include "solver/base/file.hpp"
#include "solver/run/beginning.hpp"
#include "tests/run/runs.hpp"

namespace eerie::run {
namespace {

using test::differences;
using test::run_in;
using test::short_impact;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::IsEmpty;

Scene scene_of(const char* packing) { return short_impact({{"numerics", {{"packing", packing}}}}); }

io::Snapshot uninterrupted(const Scene& scene) {
  const TemporaryFolder folder;
  run_in(folder, scene);
  return io::read_snapshot(folder / "final.hdf5");
}

/// Stops at the `n`-th question.
RunOptions stopping_at(int n) {
  RunOptions options;
  options.stop = [n, asked = 0]() mutable { return ++asked >= n; };
  return options;
}

TEST(Settling, ThatIsStoppedGoesOnAndEndsWithTheSameBits) {
  const Scene scene = scene_of("lattice");
  const TemporaryFolder folder;
  const RunSummary first = run_in(folder, scene, stopping_at(3)).summary;
  EXPECT_EQ(first.end, RunEnd::stopped);
  EXPECT_EQ(first.progress.step, 0);
  EXPECT_EQ(first.last.state.size(), 600u);  // both bodies, on their orbit
  EXPECT_TRUE(std::filesystem::exists(folder / "settling_target.hdf5"));
  const auto told = run_in(folder, scene);
  EXPECT_EQ(told.summary.end, RunEnd::finished);
  EXPECT_THAT(told.notes, testing::Contains(HasSubstr("of its way to rest")));
  EXPECT_FALSE(std::filesystem::exists(folder / "settling_target.hdf5"));
  EXPECT_THAT(differences(io::read_snapshot(folder / "final.hdf5"), uninterrupted(scene)),
              IsEmpty());
}

TEST(Settling, ThatIsStoppedWhileAGlassIsPackedGoesOnAndEndsWithTheSameBits) {
  const Scene scene = scene_of("glass");
  const TemporaryFolder folder;
  int questions = 0;
  RunOptions options;
  options.stop = [&] { return ++questions >= 3; };
  const RunSummary stopped = run_in(folder, scene, options).summary;
  EXPECT_EQ(stopped.end, RunEnd::stopped);
  EXPECT_EQ(questions, 3) << "it is not asked again, and nothing is begun";
  EXPECT_EQ(stopped.last.state.size(), 600u);
  EXPECT_EQ(run_in(folder, scene).summary.end, RunEnd::finished);
  EXPECT_THAT(differences(io::read_snapshot(folder / "final.hdf5"), uninterrupted(scene)),
              IsEmpty());
}

TEST(Settling, CountsItsStepsAndComesToItsEndPieceByPiece) {
  const Scene scene = scene_of("glass");
  const TemporaryFolder folder;
  RunOptions options;
  options.max_settling_steps = 40;
  int parts = 0;
  while (run_in(folder, scene, options).summary.end == RunEnd::step_limit && parts < 1000) ++parts;
  EXPECT_GE(parts, 2);
  EXPECT_THAT(differences(io::read_snapshot(folder / "final.hdf5"), uninterrupted(scene)),
              IsEmpty());
}

TEST(Settling, ThatWouldTakeForEverStopsWhenAsked) {
  const Scene scene = short_impact({{"numerics", {{"cfl", 1e-9}, {"packing", "lattice"}}}});
  const TemporaryFolder folder;
  EXPECT_EQ(run_in(folder, scene, stopping_at(2)).summary.end, RunEnd::stopped);
  RunOptions options;
  options.max_settling_steps = 10;
  EXPECT_EQ(run_in(folder, scene, options).summary.end, RunEnd::step_limit);
}

TEST(Settling, PassesOverDamagedFilesOfItself) {
  const Scene scene = scene_of("lattice");
  const TemporaryFolder folder;
  run_in(folder, scene, stopping_at(3));
  install_text(folder / "settling_target.hdf5", "no snapshot");
  EXPECT_EQ(run_in(folder, scene).summary.end, RunEnd::finished);
  EXPECT_THAT(differences(io::read_snapshot(folder / "final.hdf5"), uninterrupted(scene)),
              IsEmpty());
}

/// Without its first snapshot a run makes the bodies again, for the totals of the start alone.
TEST(Settling, AgainForALostFirstSnapshotStopsAndLosesNoCheckpoint) {
  const Scene scene = scene_of("lattice");
  const TemporaryFolder folder;
  RunOptions options;
  options.max_steps = 20;
  const RunSummary before = run_in(folder, scene, options).summary;
  std::filesystem::remove(folder / "snapshot_0000.hdf5");
  const RunSummary stopped = run_in(folder, scene, stopping_at(2)).summary;
  EXPECT_EQ(stopped.end, RunEnd::stopped);
  EXPECT_EQ(stopped.progress.step, before.progress.step);
  run_in(folder, scene);
  EXPECT_THAT(differences(io::read_snapshot(folder / "final.hdf5"), uninterrupted(scene)),
              IsEmpty());
}

}  // namespace
}  // namespace eerie::run
