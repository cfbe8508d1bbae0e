#include "db/store/lock.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <thread>

#include "db/store/connection.hpp"
#include "db/store/error.hpp"
#include "db/store/file_system.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::db {
namespace {
namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Lock, TellsASecondComerWhoHoldsIt) {
  const TemporaryFolder folder;
  const Lock lock(folder / "a.sqlite");
  try {
    const Lock second(folder / "a.sqlite", std::chrono::milliseconds(0));
    FAIL() << "two hold one database";
  } catch (const LockedError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("process " + std::to_string(::getpid())));
    EXPECT_THAT(error.what(), testing::HasSubstr("a.sqlite"));
  }
  EXPECT_THAT(lock_holder(folder / "a.sqlite").value_or(""),
              testing::HasSubstr(std::to_string(::getpid())));
}

TEST(Lock, IsRefusedForWhatIsNoDatabaseAndLeavesNothingBeside) {
  const test::TemporaryFolder folder;
  install_text(folder / "s.json", "{}");
  EXPECT_THAT([&] { Lock(folder / "s.json"); },
              ThrowsMessage<Error>(HasSubstr("it is not an SQLite database")));
  EXPECT_THAT([&] { Lock(folder.path() / std::string(250, 'n')); },
              ThrowsMessage<Error>(HasSubstr("choose a shorter one")));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(Lock, IsFreeAgainWhenItsHolderIsGone) {
  const TemporaryFolder folder;
  { const Lock lock(folder / "a.sqlite"); }
  EXPECT_EQ(lock_holder(folder / "a.sqlite"), std::nullopt);
  EXPECT_NO_THROW(Lock(folder / "a.sqlite"));
}

constexpr std::chrono::milliseconds at_once{0};

TEST(Lock, IsOfTheFileWhateverItIsCalled) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("a.sqlite", folder / "b.sqlite");
  const Lock lock(folder / "a.sqlite");
  EXPECT_THROW(Lock(folder / "b.sqlite", at_once), LockedError);
  EXPECT_NE(lock_holder(folder / "b.sqlite"), std::nullopt);
}

TEST(Lock, HoldsThoughTheFileThatSaysWhoIsRemoved) {
  const TemporaryFolder folder;
  const Lock lock(folder / "a.sqlite");
  std::filesystem::remove(folder / "a.sqlite.lock");
  EXPECT_THROW(Lock(folder / "a.sqlite", at_once), LockedError);
}

TEST(Lock, IsWaitedForALittle) {
  const TemporaryFolder folder;
  auto momentary = std::make_optional<Lock>(folder / "a.sqlite");
  std::jthread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    momentary.reset();
  });
  EXPECT_NO_THROW(Lock(folder / "a.sqlite", std::chrono::seconds(60)));
}

/// Closing any descriptor of a file drops all POSIX locks of the process on it.
TEST(Lock, ThatIsLetGoLeavesSqliteItsOwn) {
  const TemporaryFolder folder;
  Connection connection(folder / "a.sqlite", Access::write);
  connection.write([&](SQLite::Database&) {
    { const Lock lock(folder / "a.sqlite"); }
    const pid_t other = ::fork();
    if (other == 0) {
      const std::string command = "sqlite3 '" + (folder / "a.sqlite").string() +
                                  "' 'PRAGMA locking_mode = EXCLUSIVE; PRAGMA journal_mode = "
                                  "DELETE;' 2>&1 | grep -q -e wal -e locked";
      ::_exit(std::system(command.c_str()) == 0 ? 0 : 1);
    }
    int status = 0;
    ::waitpid(other, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 0) << "another process took the file from under SQLite";
  });
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
