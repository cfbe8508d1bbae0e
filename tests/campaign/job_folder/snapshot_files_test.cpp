#include "campaign/job_folder/snapshot_files.hpp"

#include <gmock/gmock.h>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::job_folder {
namespace {
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

class Series : public testing::Test {
 protected:
  void add(const char* name, double time, double interval = 500) {
    io::Snapshot snapshot = test::random_snapshot(8, false);
    snapshot.state.time = time;
    snapshot.scene.output.snapshot_interval_s = interval;
    io::write_snapshot(folder / name, snapshot);
  }
  std::vector<double> times() {
    std::vector<double> found;
    for (const SnapshotFile& s : snapshot_files(folder.path())) found.push_back(s.time);
    return found;
  }
  test::TemporaryFolder folder;
};

TEST_F(Series, IsInOrderOfTimeAndHasEachTimeOnce) {
  add("final.hdf5", 1000), add("snapshot_0002.hdf5", 1000), add("snapshot_0000.hdf5", 0);
  add("snapshot_0001.hdf5", 500), add("checkpoint.hdf5", 700);
  install_text(folder / "history.csv", "time_s\n");
  EXPECT_THAT(times(), ElementsAre(0, 500, 1000));
  EXPECT_EQ(snapshot_files(folder.path()).back().path.filename(), "snapshot_0002.hdf5");
}

TEST_F(Series, FolderWithoutSnapshotsIsRefused) {
  const auto empty = [&] { snapshot_files(folder.path()); };
  EXPECT_THAT(empty, ThrowsMessage<InputError>(HasSubstr("holds no snapshots")));
  const auto none = [&] { snapshot_files(folder / "none"); };
  EXPECT_THAT(none, ThrowsMessage<InputError>(HasSubstr("none: holds no snapshots")));
  install_text(folder / "snapshot_0000.hdf5", "no snapshot");
  EXPECT_THAT(empty, ThrowsMessage<InputError>(HasSubstr("not a usable snapshot")));
}

TEST_F(Series, NearestSnapshotIsTakenWithinHalfAnInterval) {
  add("snapshot_0000.hdf5", 0), add("snapshot_0001.hdf5", 503), add("final.hdf5", 1003);
  const auto series = snapshot_files(folder.path());
  EXPECT_THAT(nearest(series, {0, 240, 260, 1003, 1253}), ElementsAre(0, 0, 1, 2, 2));
  const auto beyond = [&] { nearest(series, {0, 1254}); };
  EXPECT_THAT(beyond, ThrowsMessage<InputError>(
                          testing::AllOf(HasSubstr("--panels 1254: no snapshot within 250 s"),
                                         HasSubstr("there are 0, 503, 1003 s (3 snapshots)"),
                                         HasSubstr("output.snapshot_interval_s"))));
}

TEST_F(Series, WithoutAnIntervalOnlyTheEndsAreThere) {
  add("snapshot_0000.hdf5", 0, 0), add("final.hdf5", 30000, 0);
  const auto series = snapshot_files(folder.path());
  EXPECT_THAT(nearest(series, {500, 29500}), ElementsAre(0, 1));
  EXPECT_THROW(nearest(series, {15000}), InputError);
}

TEST_F(Series, TimesInWordsNameTheFirstAndTheLast) {
  std::vector<SnapshotFile> series;
  for (int k = 0; k <= 100; ++k) series.push_back({"", 500.0 * k});
  EXPECT_EQ(times_text(series), "0, 500, 1000 ... 50000 s (101 snapshots)");
  EXPECT_EQ(times_text({series.begin(), series.begin() + 1}), "0 s (1 snapshot)");
}

}  // namespace
}  // namespace eerie::job_folder
