#include "campaign/merging/job_files.hpp"

#include <gtest/gtest.h>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::merging {
namespace {
namespace fs = std::filesystem;

class JobFiles : public testing::Test {
 protected:
  JobFiles() {
    fs::create_directories(theirs.path), fs::create_directories(ours.path.parent_path());
    install_text(theirs.result(), "theirs");
    install_text(theirs.worker_lock(), "");
  }
  test::TemporaryFolder folder;
  job_folder::JobDirectory theirs{folder / "a.jobs/0123456789abcdef"};
  job_folder::JobDirectory ours{folder / "b.jobs/0123456789abcdef"};
};

TEST_F(JobFiles, AreReachedByALinkThatLeadsToTheFolderItself) {
  EXPECT_TRUE(transfer(theirs, ours, Transfer::link));
  EXPECT_EQ(read_file(ours.result()), "theirs");
  const job_folder::JobDirectory third{folder / "b.jobs/third"};
  EXPECT_TRUE(transfer(ours, third, Transfer::link));
  EXPECT_EQ(fs::read_symlink(third.path), fs::canonical(theirs.path));
  EXPECT_TRUE(transfer(theirs, ours, Transfer::link));  // once more
  EXPECT_TRUE(half_written_files(ours.path.parent_path()).empty());
}

TEST_F(JobFiles, ThatAreCopiedOutliveTheirOriginAndHaveNoLock) {
  EXPECT_TRUE(transfer(theirs, ours, Transfer::copy));
  EXPECT_FALSE(fs::exists(ours.worker_lock()));
  fs::remove_all(theirs.path);
  EXPECT_EQ(read_file(ours.result()), "theirs");
}

TEST_F(JobFiles, ThatWereCopiedBeforeAreNotPutAside) {
  fs::create_directories(folder / "b.jobs/.0123456789abcdef.merging.tmp");
  for (int time = 0; time < 2; ++time) EXPECT_TRUE(transfer(theirs, ours, Transfer::copy));
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder / "b.jobs")) ++entries;
  EXPECT_EQ(entries, 1u);
}

TEST_F(JobFiles, ALinkBecomesACopyWhereThatIsAskedFor) {
  EXPECT_TRUE(transfer(theirs, ours, Transfer::link));
  EXPECT_TRUE(transfer(theirs, ours, Transfer::copy));
  EXPECT_FALSE(fs::is_symlink(ours.path));
  EXPECT_EQ(read_file(ours.result()), "theirs");
}

TEST_F(JobFiles, ThatWereThereAreKeptUnderAnotherName) {
  fs::create_directories(ours.path);
  install_text(ours.result(), "ours");
  EXPECT_TRUE(transfer(theirs, ours, Transfer::link));
  EXPECT_EQ(read_file(ours.result()), "theirs");
  EXPECT_EQ(read_file(ours.path.string() + ".before-merge/result.json"), "ours");
}

TEST_F(JobFiles, ThatAreGoneAreSaidToBe) {
  fs::remove_all(theirs.path);
  EXPECT_FALSE(transfer(theirs, ours, Transfer::link));
  EXPECT_FALSE(fs::exists(fs::symlink_status(ours.path)));
}

}  // namespace
}  // namespace eerie::merging
