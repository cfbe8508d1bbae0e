#include "db/store/migrations.hpp"

#include <SQLiteCpp/Database.h>
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "db/store/connection.hpp"
#include "db/store/error.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::db {
namespace {
using test::TemporaryFolder;

SQLite::Database writable(const std::filesystem::path& path) {
  return SQLite::Database(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
}

/// A database as the program of an older version left it.
void make_version(const std::filesystem::path& path, int version) {
  SQLite::Database sql = writable(path);
  for (const Migration& step : migrations())
    if (step.version <= version) sql.exec(step.sql);
  sql.exec("PRAGMA application_id = 0x65657269");
  sql.exec("PRAGMA user_version = " + std::to_string(version));
}

std::vector<std::string> schema(const std::filesystem::path& path) {
  SQLite::Database sql(path);
  std::vector<std::string> statements;
  SQLite::Statement select(sql,
                           "SELECT coalesce(sql, name) FROM sqlite_master ORDER BY type, name");
  while (select.executeStep()) statements.push_back(select.getColumn(0).getString());
  return statements;
}

TEST(Migrations, AreNumberedFromOneWithoutGaps) {
  int expected = 1;
  for (const Migration& step : migrations()) EXPECT_EQ(step.version, expected++);
  EXPECT_EQ(latest_version(), expected - 1);
}

TEST(Migrations, BringEveryOlderDatabaseToTheSchemaOfANewOne) {
  const TemporaryFolder folder;
  { const Connection fresh(folder / "fresh.sqlite", Access::write); }
  for (int version = 0; version <= latest_version(); ++version) {
    const auto path = folder.path() / ("v" + std::to_string(version) + ".sqlite");
    make_version(path, version);
    { const Connection migrated(path, Access::write); }
    EXPECT_EQ(schema(path), schema(folder / "fresh.sqlite")) << "from version " << version;
  }
}

TEST(Migrations, FindTheSettingsOfJobsThatOlderVersionsAdded) {
  const TemporaryFolder folder;
  make_version(folder / "old.sqlite", 3);
  const auto scene = [](double v, int seed, int particles, const char* end) {
    return fmt::format(
        R"({{"end":{},"impact":{{"q":1,"v_imp_cm_per_s":{}}},"numerics":{{"late_sound_speed":1.0,)"
        R"("particles_per_target":{},"seed":{}}},"output":{{"history_interval_s":{}}}}})",
        end, v, particles, seed, v);
  };
  const char* whole = R"({"settled":{"window_s":0.0},"time_s":3e4})";
  // The third lacks the field that is off in the others; the fourth has other particles.
  const std::string scenes[] = {scene(15, 1, 400, whole), scene(16, 2, 400, whole),
                                scene(17, 1, 400, R"({"time_s":3e4})"), scene(15, 1, 900, whole),
                                scene(15, 1, 400, R"({"settled":{"window_s":9},"time_s":3e4})")};
  SQLite::Database sql = writable(folder / "old.sqlite");
  for (const std::string& one : scenes) {
    sql.exec(
        "INSERT INTO jobs (hash, q, phi_d_deg, v_imp_cm_per_s, theta_imp_deg, v_over_v_esc, "
        "particles_per_target, seed, end_time_s, expected_particle_steps) "
        "VALUES ('" +
        one + "', 1, 40, 20, 15, 3, 400, 1, 1, 1)");
    sql.exec("INSERT INTO job_scenes VALUES (last_insert_rowid(), '" + one + "')");
  }
  { const Connection migrated(folder / "old.sqlite", Access::write); }
  std::vector<int> settings;
  SQLite::Statement select(sql, "SELECT settings FROM jobs ORDER BY id");
  while (select.executeStep()) settings.push_back(select.getColumn(0).getInt());
  EXPECT_THAT(settings, testing::ElementsAre(1, 1, 1, 2, 3));
  EXPECT_EQ(sql.execAndGet("SELECT scene FROM job_settings WHERE id = 1").getString(),
            R"({"end":{"time_s":3e4},"impact":{},"numerics":{"particles_per_target":400}})");
}

TEST(Migrations, RefuseADatabaseNewerThanTheProgram) {
  const TemporaryFolder folder;
  { const Connection fresh(folder / "a.sqlite", Access::write); }
  writable(folder / "a.sqlite")
      .exec("PRAGMA user_version = " + std::to_string(latest_version() + 1));
  for (const Access access : {Access::read, Access::write}) {
    try {
      const Connection connection(folder / "a.sqlite", access);
      FAIL();
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("use a newer eerie"));
    }
  }
}

TEST(Migrations, OfAReaderLeaveTheFileAsItIs) {
  const TemporaryFolder folder;
  for (int version = 1; version < latest_version(); ++version) {
    const auto path = folder.path() / ("v" + std::to_string(version) + ".sqlite");
    make_version(path, version);
    Connection(path, Access::read).read([](SQLite::Database& sql) {
      EXPECT_EQ(schema_version(sql), latest_version());
    });
    EXPECT_EQ(schema_version(*std::make_unique<SQLite::Database>(path)), version);
  }
}

TEST(Schema, KeepsTheNamesOfItsViewsForUsers) {
  const TemporaryFolder folder;
  { const Connection fresh(folder / "a.sqlite", Access::write); }
  SQLite::Database sql(folder / "a.sqlite");
  for (const char* view : {"results", "remnants", "maps"})
    EXPECT_EQ(
        sql.execAndGet(std::string("SELECT type FROM sqlite_master WHERE name = '") + view + "'")
            .getString(),
        "view");
}

TEST(Schema, RefusesAStateThatIsNone) {
  const TemporaryFolder folder;
  Connection connection(folder / "a.sqlite", Access::write);
  EXPECT_THROW(connection.write([](SQLite::Database& sql) {
    sql.exec(
        "INSERT INTO jobs (hash, state, q, phi_d_deg, v_imp_cm_per_s, theta_imp_deg, v_over_v_esc, "
        "particles_per_target, seed, end_time_s, expected_particle_steps) "
        "VALUES ('h', 'sleeping', 1, 40, 20, 15, 3, 1000, 1, 1, 1)");
  }),
               Error);
}

}  // namespace
}  // namespace eerie::db
