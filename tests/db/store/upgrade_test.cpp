#include "db/store/upgrade.hpp"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include "db/store/connection.hpp"
#include "db/store/error.hpp"
#include "db/store/migrations.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/older_database.hpp"

namespace eerie::db {
namespace {
using testing::HasSubstr;
namespace fs = std::filesystem;

/// A database of schema 5 with one job and its result.
class AnOlderDatabase : public testing::Test {
 protected:
  AnOlderDatabase() {
    {
      Connection connection(path, Access::write);
      connection.write([](SQLite::Database& sql) {
        sql.exec(R"(INSERT INTO jobs (hash, state, q, phi_d_deg, v_imp_cm_per_s, theta_imp_deg,
                      v_over_v_esc, particles_per_target, seed, end_time_s, expected_particle_steps)
                    VALUES ('0123456789abcdef01', 'done', 1, 40, 20, 15, 3, 400, 1, 1, 1))");
        sql.exec(R"(INSERT INTO job_settings (scene) VALUES ('{"numerics":{"scheme":"dual"}}'))");
        sql.exec("UPDATE jobs SET settings = 1");
      });
    }
    test::make_schema_5(path);
  }
  static std::string scheme(const Connection& connection) {
    std::string found;
    connection.read([&](SQLite::Database& sql) {
      found = sql.execAndGet("SELECT scheme FROM maps").getString();
    });
    return found;
  }

  test::TemporaryFolder folder;
  const fs::path path = folder / "old.sqlite", kept = folder / "old.sqlite.schema-5";
};

TEST_F(AnOlderDatabase, IsReadAsOneOfThisProgramAndStaysAsItIs) {
  const std::string bytes = read_file(path);
  EXPECT_EQ(schema_of_file(path), 5);
  const Connection connection(path, Access::read);
  EXPECT_EQ(scheme(connection), "dual");
  connection.read([](SQLite::Database& sql) {
    EXPECT_EQ(sql.execAndGet("SELECT job_folder FROM job_folders").getString(),
              "old.sqlite.jobs/0123456789abcdef");
    EXPECT_GT(sql.execAndGet("SELECT count(*) FROM units").getInt(), 50);
  });
  EXPECT_EQ(connection.path(), path);
  EXPECT_TRUE(read_file(path) == bytes);
  EXPECT_FALSE(fs::exists(kept));
}

TEST_F(AnOlderDatabase, IsReadWhileItsOwnProgramWritesToIt) {
  SQLite::Database older(path, SQLite::OPEN_READWRITE);
  older.exec("BEGIN IMMEDIATE; UPDATE jobs SET priority = 7");
  EXPECT_EQ(scheme(Connection(path, Access::read)), "dual");
  older.exec("COMMIT");
  Connection(path, Access::read).read([](SQLite::Database& sql) {
    EXPECT_EQ(sql.execAndGet("SELECT priority FROM jobs").getInt(), 7);
  });
}

TEST_F(AnOlderDatabase, IsKeptAsItWasWhereAWriterChangesItsSchema) {
  testing::internal::CaptureStderr();
  { EXPECT_EQ(scheme(Connection(path, Access::write)), "dual"); }
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("it is kept as " + kept.string()));
  EXPECT_EQ(schema_of_file(path), latest_version());
  EXPECT_EQ(schema_of_file(kept), 5);
  SQLite::Database copy(kept, SQLite::OPEN_READONLY);
  EXPECT_EQ(copy.execAndGet("SELECT hash FROM jobs").getString(), "0123456789abcdef01");
}

TEST_F(AnOlderDatabase, StaysAsItIsWhereItsCopyFindsNoPlace) {
  fs::create_directories(kept / "in the way");
  EXPECT_ANY_THROW(Connection(path, Access::write));
  EXPECT_EQ(schema_of_file(path), 5);
}

TEST(AnEmptyDatabase, IsNotReadAndItsReaderIsToldWhatFillsIt) {
  const test::TemporaryFolder folder;
  install_text(folder / "a b.sqlite", "");
  try {
    const Connection connection(folder / "a b.sqlite", Access::read);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("it is empty; `eerie run SWEEP --db '"));
  }
}

}  // namespace
}  // namespace eerie::db
