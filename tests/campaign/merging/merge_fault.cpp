// A merge that is killed half-way.

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <gmock/gmock.h>
#include <signal.h>

#include "tests/support/disturbed_campaign.hpp"

namespace eerie::merging {
namespace {
using test::Ended;
using test::Environment;
namespace fs = std::filesystem;

/// All rows of all tables.
std::string content(const fs::path& database) {
  const SQLite::Database sql(database);
  std::string text;
  for (const char* table : {"sweeps", "jobs", "job_scenes", "sweep_jobs", "attempts", "job_results",
                            "job_remnants", "job_settings", "settings"}) {
    SQLite::Statement select(sql, std::string("SELECT * FROM ") + table + " ORDER BY 1, 2");
    while (select.executeStep()) {
      text += "\n";
      for (int k = 0; k < select.getColumnCount(); ++k)
        text += select.getColumn(k).getString() + "|";
    }
  }
  return text;
}

class KilledMerge : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"a", "b"}) {
      test::write_sweep(
          folder.path(), 500,
          *name == 'a' ? R"({"v_imp_cm_per_s": [15, 20]})" : R"({"v_imp_cm_per_s": [20, 25]})");
      ASSERT_EQ(eerie({"run", "sweep.json", "--db", name + std::string(".sqlite")}).code, 0);
    }
  }
  Ended eerie(const std::vector<std::string>& words) { return test::eerie(folder.path(), words); }
  Ended killed_at(const char* point, const std::vector<std::string>& words) {
    const Environment armed("EERIE_KILL_AT", point);
    return eerie(words);
  }
  /// Three jobs, each done, with files, and nothing to complain of.
  void expect_all_in(const char* database) {
    SQLite::Database sql(folder / database);
    EXPECT_EQ(sql.execAndGet("SELECT count(*) FROM results").getInt(), 3);
    EXPECT_EQ(sql.execAndGet("SELECT count(*) FROM jobs WHERE state = 'done'").getInt(), 3);
    const Ended doctor = eerie({"doctor", "--db", database});
    EXPECT_EQ(doctor.code, 0) << doctor.out;
    EXPECT_EQ(test::job_directories(folder / database).size(), 3u);
  }
  test::TemporaryFolder folder;
};

TEST_F(KilledMerge, LeavesTheTargetAsItWasAndTheNextOneCompletesIt) {
  const std::string before = content(folder / "a.sqlite");
  for (const char* point : {"install.before-rename", "merge.before-commit"}) {
    const Ended ended = killed_at(point, {"merge", "a.sqlite", "b.sqlite", "--copy"});
    EXPECT_EQ(ended.code, 128 + SIGKILL) << point;
    EXPECT_EQ(content(folder / "a.sqlite"), before) << point;
  }
  const Ended again = eerie({"merge", "a.sqlite", "b.sqlite", "--copy"});
  EXPECT_EQ(again.code, 0) << again.err;
  expect_all_in("a.sqlite");
}

TEST_F(KilledMerge, LeavesNoNewDatabaseAndTheNextOneMakesIt) {
  const std::string a = content(folder / "a.sqlite"), b = content(folder / "b.sqlite");
  for (const char* point : {"merge.before-commit", "merge.before-install"}) {
    const Ended ended = killed_at(point, {"merge", "a.sqlite", "b.sqlite", "-o", "all.sqlite"});
    EXPECT_EQ(ended.code, 128 + SIGKILL) << point;
    EXPECT_FALSE(fs::exists(folder / "all.sqlite")) << point;
  }
  const Ended again = eerie({"merge", "a.sqlite", "b.sqlite", "-o", "all.sqlite"});
  EXPECT_EQ(again.code, 0) << again.err;
  expect_all_in("all.sqlite");
  EXPECT_EQ(content(folder / "a.sqlite"), a);
  EXPECT_EQ(content(folder / "b.sqlite"), b);
  for (const auto& entry : fs::directory_iterator(folder.path()))
    EXPECT_THAT(entry.path().filename().string(), testing::Not(testing::HasSubstr("merging")));
}

}  // namespace
}  // namespace eerie::merging
