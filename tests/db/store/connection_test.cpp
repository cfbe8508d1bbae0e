#include "db/store/connection.hpp"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include <fstream>

#include "db/store/error.hpp"
#include "db/store/migrations.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::db {
namespace {
using test::TemporaryFolder;

/// The text of the error that opening gives.
std::string refusal(const std::filesystem::path& path, Access access) {
  try {
    const Connection connection(path, access);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Connection, MakesADatabaseInWalModeWithTheNewestSchema) {
  const TemporaryFolder folder;
  Connection connection(folder / "a.sqlite", Access::write);
  connection.read([](SQLite::Database& sql) {
    EXPECT_EQ(sql.execAndGet("PRAGMA journal_mode").getString(), "wal");
    EXPECT_EQ(sql.execAndGet("PRAGMA foreign_keys").getInt(), 1);
    EXPECT_EQ(sql.execAndGet("PRAGMA user_version").getInt(), latest_version());
  });
  EXPECT_EQ(connection.integrity(), "ok");
}

TEST(Connection, ForReadingRefusesAFileThatIsNotThereAndMakesNone) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder / "a.sqlite", Access::read),
              testing::HasSubstr("there is no such file"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.sqlite"));
}

TEST(Connection, RefusesAFileThatIsNoDatabaseAndLeavesItAsItIs) {
  const TemporaryFolder folder;
  const std::string text(4096, 'x');
  std::ofstream(folder / "notes.txt") << text;
  for (const Access access : {Access::read, Access::write}) {
    const std::string said = refusal(folder / "notes.txt", access);
    EXPECT_THAT(said, testing::HasSubstr("notes.txt"));
    EXPECT_THAT(said, testing::HasSubstr("not an SQLite database"));
  }
  std::ifstream in(folder / "notes.txt");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), text);
}

TEST(Connection, RefusesTheDatabaseOfAnotherProgram) {
  const TemporaryFolder folder;
  SQLite::Database(folder / "other.sqlite", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("CREATE TABLE bookmarks (url TEXT)");
  EXPECT_THAT(refusal(folder / "other.sqlite", Access::write),
              testing::HasSubstr("another program"));
}

TEST(Connection, RefusesAFolder) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder.path(), Access::write), testing::HasSubstr("it is a folder"));
}

TEST(Connection, RefusesAFileInAFolderThatIsNotThere) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder / "no/a.sqlite", Access::write),
              testing::HasSubstr("make the folder"));
}

TEST(Connection, TakesBackAllOfAWriteThatFails) {
  const TemporaryFolder folder;
  Connection connection(folder / "a.sqlite", Access::write);
  EXPECT_THROW(connection.write([](SQLite::Database& sql) {
    sql.exec("INSERT INTO sweeps (name, document) VALUES ('a', '{}')");
    throw std::runtime_error("the disk is gone");
  }),
               std::runtime_error);
  connection.read([](SQLite::Database& sql) {
    EXPECT_EQ(sql.execAndGet("SELECT count(*) FROM sweeps").getInt(), 0);
  });
}

TEST(Connection, NamesFileAndReasonOfABrokenStatement) {
  const TemporaryFolder folder;
  Connection connection(folder / "a.sqlite", Access::write);
  try {
    connection.write([](SQLite::Database& sql) { sql.exec("INSERT INTO nowhere VALUES (1)"); });
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(testing::HasSubstr("a.sqlite"), testing::HasSubstr("nowhere")));
  }
}

TEST(Connection, LetsOthersReadWhileItWrites) {
  const TemporaryFolder folder;
  Connection writer(folder / "a.sqlite", Access::write);
  writer.write([&](SQLite::Database& sql) {
    sql.exec("INSERT INTO sweeps (name, document) VALUES ('a', '{}')");
    const Connection reader(folder / "a.sqlite", Access::read);
    reader.read([](SQLite::Database& other) {
      EXPECT_EQ(other.execAndGet("SELECT count(*) FROM sweeps").getInt(), 0);
    });
  });
}

}  // namespace
}  // namespace eerie::db
