#include "db/store/place.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include "db/store/connection.hpp"
#include "db/store/error.hpp"
#include "db/store/lock.hpp"
#include "solver/base/error.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::db {
namespace {
using test::TemporaryFolder;
using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(Place, RefusesNamesUnderWhichSqliteKeepsNothing) {
  for (const char* name : {"", ":memory:", "file:a.sqlite", "file:a?mode=memory"}) {
    EXPECT_THROW(resolved(name), InputError) << name;
    EXPECT_THROW(Lock{name}, InputError) << name;
    for (const Access access : {Access::read, Access::read_any, Access::write})
      EXPECT_THROW(Connection(name, access), InputError) << name;
  }
  EXPECT_EQ(resolved("./file:a"), "./file:a");
}

TEST(Place, RefusesWhatIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_THROW(resolved(folder.path()), Error);
  EXPECT_THROW(resolved("/dev/null"), Error);
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THROW(resolved(folder / "pipe"), Error);
  fs::create_symlink("round", folder / "round");
  EXPECT_THROW(resolved(folder / "round"), Error);
}

TEST(Place, IsThatOfTheFileBehindEverySymbolicLink) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "there");
  fs::create_symlink("there/a.sqlite", folder / "b.sqlite");
  fs::create_symlink(folder / "b.sqlite", folder / "c.sqlite");
  EXPECT_EQ(resolved(folder / "c.sqlite"), folder / "there/a.sqlite");  // also before it is there
  const Connection connection(folder / "c.sqlite", Access::write);
  EXPECT_EQ(connection.path(), folder / "there/a.sqlite");
  EXPECT_TRUE(fs::exists(folder / "there/a.sqlite"));
}

/// SQLite would keep a log under each name, and damage the file.
TEST(Place, RefusesAFileOfTwoNames) {
  const TemporaryFolder folder;
  { const Connection connection(folder / "a.sqlite", Access::write); }
  fs::create_hard_link(folder / "a.sqlite", folder / "b.sqlite");
  for (const char* name : {"a.sqlite", "b.sqlite"}) {
    EXPECT_THROW(Lock{folder / name}, Error);
    EXPECT_THROW(Connection(folder / name, Access::read), Error);
    EXPECT_THROW(Connection(folder / name, Access::write), Error);
  }
  fs::remove(folder / "b.sqlite");
  EXPECT_NO_THROW(Connection(folder / "a.sqlite", Access::read));
}

}  // namespace
}  // namespace eerie::db
