#include "db/store/lock.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include "db/store/error.hpp"
#include "db/store/file_system.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::db {
namespace {
using test::TemporaryFolder;

TEST(Lock, TellsASecondComerWhoHoldsIt) {
  const TemporaryFolder folder;
  const Lock lock(folder / "a.sqlite");
  try {
    const Lock second(folder / "a.sqlite");
    FAIL() << "two hold one database";
  } catch (const LockedError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("process " + std::to_string(::getpid())));
    EXPECT_THAT(error.what(), testing::HasSubstr("a.sqlite"));
  }
  EXPECT_THAT(lock_holder(folder / "a.sqlite").value_or(""),
              testing::HasSubstr(std::to_string(::getpid())));
}

TEST(Lock, IsFreeAgainWhenItsHolderIsGone) {
  const TemporaryFolder folder;
  { const Lock lock(folder / "a.sqlite"); }
  EXPECT_EQ(lock_holder(folder / "a.sqlite"), std::nullopt);
  EXPECT_NO_THROW(Lock(folder / "a.sqlite"));
}

TEST(FileSystem, KnowsTheNetworkOnes) {
  EXPECT_STREQ(network_file_system(0x6969), "NFS");
  EXPECT_STREQ(network_file_system(0x47504653), "GPFS");
  EXPECT_STREQ(network_file_system(0x0BD00BD0), "Lustre");
  EXPECT_STREQ(network_file_system(0xFFFFFFFFFF534D42), "CIFS");  // statfs gives it sign-extended
}

TEST(FileSystem, KnowsTheLocalOnes) {
  for (const unsigned long type :
       {0xEF53UL, 0x58465342UL, 0x9123683EUL, 0x01021994UL, 0x794C7630UL})
    EXPECT_EQ(network_file_system(type), nullptr);
}

}  // namespace
}  // namespace eerie::db
