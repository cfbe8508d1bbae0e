#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>

#include "db/jobs.hpp"
#include "solver/base/file.hpp"
#include "tests/db/sample_jobs.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::db {
namespace {

/// The ```sql blocks of a Markdown file.
std::vector<std::string> sql_blocks(const std::string& markdown) {
  const std::string open = "```sql\n", close = "```";
  std::vector<std::string> blocks;
  for (std::size_t at = markdown.find(open); at != std::string::npos;
       at = markdown.find(open, at)) {
    const std::size_t begin = at + open.size();
    at = markdown.find(close, begin);
    blocks.push_back(markdown.substr(begin, at - begin));
  }
  return blocks;
}

TEST(DocumentedSql, RunsAndFindsTheResultsThatAreThere) {
  const test::TemporaryFolder folder;
  Connection connection(folder / "a.sqlite", Access::write);
  add_sweep(connection, "s", "{}", test::sample_jobs(1));
  begin_attempts(connection, std::vector{Start{1, "here", "1", "0.1.0"}});
  finish(connection, 1, test::ended(ExitReason::finished), test::sample_result(0.24),
         std::vector<Remnant>{
             Remnant{.rank = 1, .mass_over_total = 0.97, .b_over_a = 0.24, .eer = true}});

  const auto blocks = sql_blocks(read_file(EERIE_SOURCE_DIR "/docs/database.md"));
  EXPECT_GE(blocks.size(), 5u);
  SQLite::Database sql(folder / "a.sqlite");
  for (const std::string& block : blocks) {
    SQLite::Statement select(sql, block);
    EXPECT_TRUE(select.executeStep()) << "no row from\n" << block;
  }
}

}  // namespace
}  // namespace eerie::db
