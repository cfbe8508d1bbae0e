// The campaign against what surrounds it: disks that fill up, clocks that jump.

#include <gmock/gmock.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <unistd.h>

#include <fstream>

#include "solver/base/free_space.hpp"
#include "tests/support/disturbed_campaign.hpp"
#include "tests/support/sanitizer.hpp"

namespace eerie::manager {
namespace {
using test::DisturbedCampaign;
using test::Environment;
using test::Program;
namespace fs = std::filesystem;

/// A disk of its own, seen by this process and the programs that it starts alone.
class SmallDisk {
 public:
  explicit SmallDisk(const char* size) {
    const int name_space = ::geteuid() == 0 ? CLONE_NEWNS : CLONE_NEWNS | CLONE_NEWUSER;
    mounted_ = ::unshare(name_space) == 0 &&
               ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
               ::mount("tmpfs", folder_.path().c_str(), "tmpfs", 0,
                       (std::string("size=") + size).c_str()) == 0;
  }
  ~SmallDisk() {
    if (mounted_) ::umount2(folder_.path().c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool is_there() const { return mounted_; }
  const fs::path& path() const { return folder_.path(); }

 private:
  test::TemporaryFolder folder_;
  bool mounted_ = false;
};

/// Fills a disk up but for so many bytes.
void fill(const fs::path& file, const fs::path& folder, std::uintmax_t leave) {
  const std::uintmax_t free = free_bytes(folder).value();
  ASSERT_GT(free, leave);
  std::ofstream(file, std::ios::binary) << std::string(free - leave, 'x');
}

class FullDisk : public testing::TestWithParam<int> {};

TEST_P(FullDisk, IsWaitedForAndNothingTornIsTakenForTrue) {
  const SmallDisk disk("6m");
  if (!disk.is_there()) GTEST_SKIP() << "this system lets no test mount a disk of its own";
  const DisturbedCampaign campaign(disk.path(), 6, 3000);
  const fs::path ballast = disk.path() / "ballast";
  fill(ballast, disk.path(), static_cast<std::uintmax_t>(GetParam()) * 1024);
  Program daemon(campaign.folder(), campaign.daemon_words());
  EXPECT_TRUE(test::eventually([&] {
    return !daemon.running() || daemon.said().find("full") != std::string::npos;
  })) << "it never found the disk full: "
      << daemon.said();
  const bool can_be_read = GetParam() > 64;  // SQLite needs room for the index of its log
  test::Ended status;
  EXPECT_TRUE(!can_be_read || test::eventually([&] {
    status = test::eerie(disk.path(), {"status"});
    return status.out.find("waiting: ") != std::string::npos;
  })) << status.out
      << status.err << daemon.said();
  EXPECT_TRUE(daemon.running()) << "it waits, it does not end: " << daemon.wait().err;
  EXPECT_TRUE(!can_be_read || !campaign.everything_is_done());
  fs::remove(ballast);
  const test::Ended ended = daemon.wait(std::chrono::seconds(180));  // it goes on by itself
  EXPECT_EQ(ended.code, 0) << ended.err;
  campaign.expect_whole();
  EXPECT_EQ(campaign.number("SELECT sum(crashes) FROM jobs"), 0) << "nobody is to blame";
}

// From no room at all, through too little for the database, to too little for some of the jobs.
INSTANTIATE_TEST_SUITE_P(WithSoManyKilobytesLeft, FullDisk, testing::Values(8, 100, 300, 600),
                         testing::PrintToStringParamName());

TEST(AFullDisk, KeepsNoDaemonFromEndingWhenTold) {
  const SmallDisk disk("6m");
  if (!disk.is_there()) GTEST_SKIP() << "this system lets no test mount a disk of its own";
  const DisturbedCampaign campaign(disk.path(), 4, 3000);
  Program daemon(campaign.folder(), campaign.daemon_words());
  ASSERT_TRUE(test::eventually([&] { return !campaign.workers().empty(); })) << daemon.said();
  const fs::path ballast = disk.path() / "ballast";
  fill(ballast, disk.path(), 8 * 1024);
  ASSERT_TRUE(test::eventually([&] {
    return daemon.said().find("event=waiting") != std::string::npos;
  })) << daemon.said();
  daemon.send(SIGTERM);
  EXPECT_EQ(daemon.wait(std::chrono::seconds(60)).code, 0);
  fs::remove(ballast);
  campaign.finish_in_peace();
  campaign.expect_whole();
}

TEST(Clocks, ThatJumpChangeNothing) {
  if (test::is_sanitized)
    GTEST_SKIP() << "a sanitizer must be loaded first, and so must libfaketime";
  const fs::path library = "/usr/lib/x86_64-linux-gnu/faketime/libfaketime.so.1";
  if (!fs::exists(library)) GTEST_SKIP() << "libfaketime is not installed";
  const test::TemporaryFolder folder;
  const DisturbedCampaign campaign(folder.path(), 3, 8000);
  const Environment preload("LD_PRELOAD", library.string());
  const Environment honest_durations("DONT_FAKE_MONOTONIC", "1");
  for (const char* jump : {"+40d", "-40d", "+3650d"}) {
    const Environment time("FAKETIME", jump);
    Program daemon(campaign.folder(), campaign.daemon_words());
    test::eventually([&] { return !campaign.workers().empty() || !daemon.running(); });
    daemon.send(SIGKILL);
    daemon.wait();
  }
  const Environment time("FAKETIME", "-1d");
  campaign.finish_in_peace();
  campaign.expect_whole();
  EXPECT_EQ(campaign.number("SELECT sum(crashes) FROM jobs"), 0);
}

}  // namespace
}  // namespace eerie::manager
