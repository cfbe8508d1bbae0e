#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>

#include "db/jobs/jobs.hpp"
#include "solver/base/file.hpp"
#include "tests/db/jobs/sample_jobs.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/markdown.hpp"
#include "tests/support/paths.hpp"

namespace eerie::db {
namespace {

TEST(DocumentedSql, RunsAndFindsTheResultsThatAreThere) {
  const test::TemporaryFolder folder;
  Connection connection(folder / "a.sqlite", Access::write);
  std::vector<NewJob> jobs = test::sample_jobs(1);
  jobs[0].fidelity = "survey";
  add_sweep(connection, "s", "{}", jobs);
  begin_attempts(connection, std::vector{Start{1, "here", "1", "0.1.0"}});
  finish(connection, 1, test::ended(ExitReason::finished), test::sample_result(0.24),
         std::vector<Remnant>{Remnant{.rank = 1,
                                      .mass_kg = 9,
                                      .mass_over_total = 0.9,
                                      .b_over_a = 0.24,
                                      .eer = true,
                                      .bound_group = 1,
                                      .x_m = 0,
                                      .y_m = 0,
                                      .z_m = 0},
                              Remnant{.rank = 2,
                                      .mass_kg = 0.9,
                                      .mass_over_total = 0.09,
                                      .bound_group = 1,
                                      .x_m = 300,
                                      .y_m = -400,
                                      .z_m = 0}});

  const auto blocks =
      test::code_blocks(read_file(test::source_folder() / "docs/how-to/pandas.md"), "sql");
  EXPECT_GE(blocks.size(), 7u);
  SQLite::Database sql(folder / "a.sqlite");
  for (const std::string& block : blocks) {
    SQLite::Statement select(sql, block);
    EXPECT_TRUE(select.executeStep()) << "no row from\n" << block;
    const std::string last = select.getColumnName(select.getColumnCount() - 1);
    if (last == "distance_m") {
      EXPECT_DOUBLE_EQ(select.getColumn(last.c_str()).getDouble(), 500);
    }
    if (last == "remnants_at_least_as_massive_per_impact") {
      EXPECT_EQ(select.getColumn(last.c_str()).getDouble(), 1);
      EXPECT_TRUE(select.executeStep());
      EXPECT_EQ(select.getColumn(last.c_str()).getDouble(), 2);
    }
  }
}

}  // namespace
}  // namespace eerie::db
