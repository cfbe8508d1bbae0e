#include "campaign/manager/space_guard.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "solver/base/free_space.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::manager {
namespace {
using Clock = SpaceGuard::Clock;
using std::chrono::seconds;

TEST(SpaceGuard, IsContentWithRoom) {
  const test::TemporaryFolder folder;
  SpaceGuard guard({folder.path()}, 0);
  EXPECT_EQ(guard.complaint(Clock::now()), std::nullopt);
}

TEST(SpaceGuard, NamesTheFolderAndWhatIsWanted) {
  const test::TemporaryFolder folder;
  SpaceGuard guard({folder.path()}, std::numeric_limits<std::uintmax_t>::max());
  const auto complaint = guard.complaint(Clock::now());
  ASSERT_TRUE(complaint);
  EXPECT_THAT(*complaint, testing::HasSubstr(folder.path().string()));
  EXPECT_THAT(*complaint, testing::HasSubstr("MB"));
}

TEST(SpaceGuard, WaitsTwiceAsLongEachTimeADiskWasFullUntilAJobGetsThrough) {
  const test::TemporaryFolder folder;
  SpaceGuard guard({folder.path()}, 0);
  const Clock::time_point start = Clock::now();
  guard.was_full(start);
  EXPECT_TRUE(guard.complaint(start));
  for (int again = 0; again < 9; ++again) guard.was_full(start);
  EXPECT_FALSE(guard.complaint(start + seconds(1))) << "told again before it was tried again";
  guard.was_full(start);
  EXPECT_TRUE(guard.complaint(start + seconds(1)));
  EXPECT_FALSE(guard.complaint(start + seconds(2)));
  guard.was_well();
  guard.was_full(start);
  EXPECT_FALSE(guard.complaint(start + seconds(1)));
}

// Asking for more than there is would fill the disk of whoever runs this test for a moment; a
// full disk has its tests in surroundings_fault.cpp.
TEST(Disk, HasRoomForAByte) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(has_room(folder.path(), 1));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "the probe is removed";
  EXPECT_EQ(free_bytes(folder / "missing"), std::nullopt);
}

}  // namespace
}  // namespace eerie::manager
