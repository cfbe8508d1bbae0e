#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <gmock/gmock.h>
#include <signal.h>

#include <nlohmann/json.hpp>

#include "db/store/lock.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// Rows of a query, with all digits, one per line.
std::string rows(const fs::path& database, const std::string& sql) {
  const SQLite::Database opened(database);
  SQLite::Statement select(opened, sql);
  std::string text;
  while (select.executeStep()) {
    for (int k = 0; k < select.getColumnCount(); ++k)
      text += std::string(select.getColumnName(k)) + "=" + select.getColumn(k).getString() + " ";
    text += "\n";
  }
  return text;
}

/// Columns of a view without those that name rows, or tell of machine and moment.
std::string lasting_columns(const fs::path& database, const std::string& view) {
  const SQLite::Database opened(database);
  SQLite::Statement select(
      opened, "SELECT group_concat('v.' || name, ', ') FROM pragma_table_info('" + view +
                  "') WHERE name NOT IN ('job', 'settings', 'wall_s', " +
                  "'threads', 'host', 'finished', 'job_folder')");
  select.executeStep();
  return select.getColumn(0).getString();
}

/// All that a campaign has found.
std::string findings(const fs::path& database) {
  return rows(database, "SELECT " + lasting_columns(database, "results") +
                            " FROM results v ORDER BY v.hash") +
         rows(database,
              "SELECT j.hash, " + lasting_columns(database, "remnants") +
                  " FROM remnants v JOIN jobs j ON j.id = v.job ORDER BY j.hash, v.rank") +
         rows(database,
              "SELECT hash, state, scene FROM jobs JOIN job_scenes ON job_id = id "
              "ORDER BY hash");
}

class MergedDatabases : public testing::Test {
 protected:
  Ended eerie(const std::vector<std::string>& words) { return test::eerie(folder.path(), words); }
  Ended run(const char* sweep, const char* database, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"run", sweep, "--db", database, "--workers", "2"});
    return test::Program(folder.path(), more).wait(std::chrono::seconds(900));
  }
  test::TemporaryFolder folder;
};

TEST_F(MergedDatabases, OfTwoHalvesOfTable2AreTheWhole) {
  const json whole = json::parse(read_file(test::source_folder() / "sweeps/table2-fig2b.json"));
  const std::vector<std::string> small = {"--set", "numerics.particles_per_target=100",
                                          "--set", "end.time_s=300",
                                          "--set", "numerics.packing=lattice"};
  const auto part = [&](const char* name, int from, int to) {
    json sweep = whole;
    sweep["grid"]["v_imp_cm_per_s"] = {{"from", from}, {"to", to}, {"step", 1}};
    install_text(folder / name, sweep.dump());
  };
  part("whole.json", 15, 30), part("slow.json", 15, 22), part("fast.json", 22, 30);
  ASSERT_EQ(run("whole.json", "whole.sqlite", small).code, 0);
  ASSERT_EQ(run("slow.json", "slow.sqlite", small).code, 0);
  ASSERT_EQ(run("fast.json", "fast.sqlite", small).code, 0);
  const Ended merged = eerie({"merge", "slow.sqlite", "fast.sqlite", "-o", "all.sqlite", "--json"});
  ASSERT_EQ(merged.code, 0) << merged.err;
  const json told = json::parse(merged.out);
  EXPECT_EQ(told.at("sources").at(0).at("added"), 48);
  EXPECT_EQ(told.at("sources").at(1).at("jobs"), 54);
  EXPECT_EQ(told.at("sources").at(1).at("added"), 48);
  EXPECT_TRUE(told.at("sources").at(1).at("differing").empty());
  const std::string found = findings(folder / "all.sqlite");
  EXPECT_EQ(found, findings(folder / "whole.sqlite"));
  EXPECT_EQ(std::ranges::count(rows(folder / "all.sqlite", "SELECT hash FROM results"), '\n'), 96);
  // Into the first one it is the same.
  ASSERT_EQ(eerie({"merge", "slow.sqlite", "fast.sqlite"}).code, 0);
  EXPECT_EQ(findings(folder / "slow.sqlite"), found);
  // The whole has nothing left to do in it, and finds its files.
  EXPECT_THAT(run("whole.json", "all.sqlite", small).out, HasSubstr("nothing left to do"));
  const Ended doctor = eerie({"doctor", "--db", "all.sqlite"});
  EXPECT_EQ(doctor.code, 0) << doctor.out;
  const Ended compared = eerie({"compare", "whole.sqlite", "all.sqlite", "--json"});
  EXPECT_EQ(compared.code, 0) << compared.err;
  const json impacts = json::parse(compared.out).at("impacts");
  EXPECT_EQ(impacts.size(), 96u);
  for (const json& impact : impacts) EXPECT_EQ(impact.at("same_results"), 1) << impact;
}

TEST_F(MergedDatabases, WithCopiedFilesNeedTheirSourcesNoMore) {
  test::write_sweep(folder.path(), 300, R"({"v_imp_cm_per_s": [15, 20]})");
  ASSERT_EQ(run("sweep.json", "a.sqlite").code, 0);
  ASSERT_EQ(eerie({"merge", "a.sqlite", "-o", "moved.sqlite", "--copy"}).code, 0);
  fs::remove_all(folder / "a.sqlite.jobs");
  const Ended doctor = eerie({"doctor", "--db", "moved.sqlite"});
  EXPECT_EQ(doctor.code, 0) << doctor.out;
  EXPECT_EQ(eerie({"analyse", "--db", "moved.sqlite"}).code, 0);
}

TEST_F(MergedDatabases, LetWhatWasInterruptedGoOnFromItsCheckpoint) {
  test::write_slow_sweep(folder.path(), R"({"v_imp_cm_per_s": [20]})");
  test::Program first(folder.path(), {"run", "sweep.json", "--db", "a.sqlite"});
  ASSERT_TRUE(test::eventually([&] {
    for (const fs::path& job : test::job_directories(folder / "a.sqlite"))
      if (fs::exists(job / "checkpoint.hdf5")) return true;
    return false;
  }));
  first.send(SIGINT);
  ASSERT_EQ(first.wait().code, 130);
  ASSERT_EQ(eerie({"merge", "a.sqlite", "-o", "b.sqlite"}).code, 0);
  ASSERT_EQ(run("sweep.json", "b.sqlite").code, 0);
  EXPECT_THAT(read_file(test::job_directories(folder / "b.sqlite").at(0) / "log.txt"),
              HasSubstr("going on from"));
  // The first one finds the result in the directory that both have.
  const Ended there = run("sweep.json", "a.sqlite");
  EXPECT_EQ(there.code, 0) << there.err;
  EXPECT_EQ(rows(folder / "a.sqlite", "SELECT steps FROM results"),
            rows(folder / "b.sqlite", "SELECT steps FROM results"));
}

TEST_F(MergedDatabases, AreRefusedWithAReason) {
  test::write_sweep(folder.path(), 300, R"({"v_imp_cm_per_s": [15]})");
  for (const char* name : {"a.sqlite", "b.sqlite"}) ASSERT_EQ(run("sweep.json", name).code, 0);
  const auto refused = [&](const std::vector<std::string>& words, int code, const char* reason) {
    const Ended ended = eerie(words);
    EXPECT_EQ(ended.code, code) << reason;
    EXPECT_THAT(ended.err, HasSubstr(reason));
  };
  refused({"merge", "a.sqlite"}, 2, "nothing to merge");
  refused({"merge", "a.sqlite", "./a.sqlite"}, 2, "are one database");
  refused({"merge", "a.sqlite", "b.sqlite", "-o", "b.sqlite"}, 2, "it is there already");
  refused({"merge", "a.sqlite", "c.sqlite"}, 3, "c.sqlite");
  refused({"merge", "c.sqlite", "a.sqlite"}, 3, "c.sqlite");
  EXPECT_FALSE(fs::exists(folder / "c.sqlite"));
  const db::Lock manager(folder / "a.sqlite");
  refused({"merge", "a.sqlite", "b.sqlite"}, 3, "process");
  EXPECT_EQ(eerie({"merge", "b.sqlite", "a.sqlite"}).code, 0);  // a source may be worked on
}

}  // namespace
}  // namespace eerie
