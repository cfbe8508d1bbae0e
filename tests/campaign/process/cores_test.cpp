#include "campaign/process/cores.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "solver/base/file.hpp"
#include "solver/base/files/folders.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::process {
namespace {
namespace fs = std::filesystem;

/// A system's files on control groups.
class CpuQuota : public testing::Test {
 protected:
  void put(const std::string& file, const std::string& text) {
    make_folders((folder.path() / file).parent_path());
    install_text(folder.path() / file, text);
  }
  CgroupPlaces places() { return {folder / "cgroup", folder / "mounted"}; }
  std::optional<double> quota() { return cpu_quota(places()); }
  test::TemporaryFolder folder;
};

TEST_F(CpuQuota, IsThatOfVersion2) {
  put("cgroup", "0::/user.slice/job\n");
  put("mounted/user.slice/job/cpu.max", "250000 100000\n");
  EXPECT_EQ(quota(), 2.5);
}

TEST_F(CpuQuota, IsTheSmallestOfTheGroupAndThoseAbove) {
  put("cgroup", "0::/a/b\n");
  put("mounted/a/b/cpu.max", "max 100000\n");
  EXPECT_EQ(quota(), std::nullopt);
  put("mounted/a/cpu.max", "300000 100000\n");
  EXPECT_EQ(quota(), 3);
  put("mounted/cpu.max", "50000 100000\n");
  EXPECT_EQ(quota(), 0.5);
}

TEST_F(CpuQuota, IsThatOfVersion1) {
  put("cgroup", "7:cpuset:/x\n4:cpu,cpuacct:/job\n0::/\n");
  put("mounted/cpu,cpuacct/job/cpu.cfs_quota_us", "400000\n");
  put("mounted/cpu,cpuacct/job/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(quota(), 4);
  put("mounted/cpu,cpuacct/job/cpu.cfs_quota_us", "-1\n");
  EXPECT_EQ(quota(), std::nullopt);
}

TEST_F(CpuQuota, OfAContainerThatSeesItsOwnGroupAlone) {
  put("cgroup", "0::/docker/0123abc\n");
  put("mounted/cpu.max", "200000 100000\n");
  EXPECT_EQ(quota(), 2);
}

TEST_F(CpuQuota, IsNoneWhereNobodyTellsOfOne) {
  EXPECT_EQ(quota(), std::nullopt);
  put("cgroup", "nonsense\n0::\n");
  put("mounted/cpu.max", "\n");
  EXPECT_EQ(quota(), std::nullopt);
}

TEST_F(CpuQuota, LimitsTheCoresThatAreUsed) {
  const std::size_t all = usable_cores(places());
  put("cgroup", "0::/\n");
  put("mounted/cpu.max", "100000000 100000\n");
  EXPECT_EQ(usable_cores(places()), all) << "a quota of 1000 cores";
  put("mounted/cpu.max", "190000 100000\n");
  EXPECT_EQ(usable_cores(places()), 1u) << "1.9 cores";
  put("mounted/cpu.max", "50000 100000\n");
  EXPECT_EQ(usable_cores(places()), 1u) << "half a core";
}

TEST(UsableCores, AreOneAtLeastAndNoMoreThanTheMachineHas) {
  EXPECT_GE(usable_cores(), 1u);
  EXPECT_LE(usable_cores(), std::thread::hardware_concurrency());
}

}  // namespace
}  // namespace eerie::process
