#include "db/store/connection.hpp"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

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

/// What a user reads who may not write: root would be let through.
std::string read_by_a_stranger(const std::filesystem::path& path) {
  const std::filesystem::path answer = path.parent_path() / "answer.txt";
  std::ofstream(answer) << "none";
  std::filesystem::permissions(answer, std::filesystem::perms::all);
  std::ofstream out(answer);  // opened before the rights are given up
  const pid_t reader = ::fork();
  if (reader == 0) {
    if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(1);
    try {
      const Connection connection(path, Access::read);
      connection.read([&](SQLite::Database& sql) {
        out << sql.execAndGet("SELECT count(*) FROM sweeps").getInt() << std::flush;
      });
    } catch (const std::exception& error) {
      out << error.what() << std::flush;
    }
    ::_exit(0);
  }
  ::waitpid(reader, nullptr, 0);
  out.close();
  std::ifstream in(answer);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A database of two sweeps, one of them in the log alone, as a writer leaves it that is killed.
class ReadOnlyPlace : public testing::Test {
 protected:
  ReadOnlyPlace() {
    namespace fs = std::filesystem;
    fs::create_directory(place);
    fs::create_directory(folder / "made");
    Connection writer(folder / "made/a.sqlite", Access::write);
    insert(writer);
    writer.read([](SQLite::Database& sql) { sql.exec("PRAGMA wal_checkpoint(TRUNCATE)"); });
    fs::copy_file(folder / "made/a.sqlite", place / "a.sqlite");
    insert(writer);
    fs::copy_file(folder / "made/a.sqlite-wal", place / "a.sqlite-wal");
    fs::copy_file(folder / "made/a.sqlite-shm", place / "a.sqlite-shm");
    fs::permissions(folder.path(), fs::perms::all);
  }
  ~ReadOnlyPlace() override {
    std::filesystem::permissions(place, std::filesystem::perms::owner_all);
  }
  static void insert(Connection& writer) {
    writer.write([](SQLite::Database& sql) {
      sql.exec("INSERT INTO sweeps (name, document) VALUES (hex(randomblob(8)), '{}')");
    });
  }
  std::string read() {
    namespace fs = std::filesystem;
    for (const auto& entry : fs::directory_iterator(place))
      fs::permissions(entry.path(), fs::perms(0444));
    fs::permissions(place, fs::perms(0555));
    return read_by_a_stranger_in(place / "a.sqlite");
  }
  std::string read_by_a_stranger_in(const std::filesystem::path& path) {
    // The answer lies outside of the place.
    std::filesystem::create_symlink(path, folder / "link.sqlite");
    return read_by_a_stranger(folder / "link.sqlite");
  }

  TemporaryFolder folder;
  std::filesystem::path place = folder / "place";
};

TEST_F(ReadOnlyPlace, WithLogAndIndexIsRead) { EXPECT_EQ(read(), "2"); }

TEST_F(ReadOnlyPlace, WithALogAloneIsReadFromACopyOfBoth) {
  std::filesystem::remove(place / "a.sqlite-shm");
  EXPECT_EQ(read(), "2");
}

TEST_F(ReadOnlyPlace, WithoutALogIsReadAsItIs) {
  std::filesystem::remove(place / "a.sqlite-shm");
  std::filesystem::remove(place / "a.sqlite-wal");
  EXPECT_EQ(read(), "1");
}

TEST_F(ReadOnlyPlace, WithAnEmptyLogIsReadAsItIs) {
  std::filesystem::remove(place / "a.sqlite-shm");
  std::ofstream(place / "a.sqlite-wal").flush();
  EXPECT_EQ(read(), "1");
}

TEST(Connection, NoticesThatItsFileWasRemovedOrReplaced) {
  const TemporaryFolder folder;
  Connection connection(folder / "a.sqlite", Access::write);
  EXPECT_NO_THROW(connection.require_in_place());
  std::filesystem::rename(folder / "a.sqlite", folder / "b.sqlite");
  EXPECT_THROW(connection.require_in_place(), GoneError);
  EXPECT_THROW(connection.write([](SQLite::Database&) {}), GoneError);
  { const Connection another(folder / "a.sqlite", Access::write); }
  EXPECT_THROW(connection.write([](SQLite::Database&) {}), GoneError);
}

TEST(Connection, SaysThatAnotherProgramWrites) {
  const TemporaryFolder folder;
  Connection one(folder / "a.sqlite", Access::write), other(folder / "a.sqlite", Access::write);
  other.wait_at_most(std::chrono::milliseconds(1));
  one.write(
      [&](SQLite::Database&) { EXPECT_THROW(other.write([](SQLite::Database&) {}), BusyError); });
  EXPECT_NO_THROW(other.write([](SQLite::Database&) {}));
}

}  // namespace
}  // namespace eerie::db
