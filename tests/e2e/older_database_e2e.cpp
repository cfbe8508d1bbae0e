#include <gmock/gmock.h>
#include <signal.h>

#include <nlohmann/json.hpp>

#include "db/store/migrations.hpp"
#include "db/store/upgrade.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/older_database.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// A campaign of one impact that a program with schema 5 has left.
class OlderDatabase : public testing::Test {
 protected:
  OlderDatabase() {
    test::write_sweep(folder.path(), 300, R"({"v_imp_cm_per_s": [20]})");
    EXPECT_EQ(eerie({"run", "sweep.json"}).code, 0);
    test::make_schema_5(database);
  }
  Ended eerie(const std::vector<std::string>& words) { return test::eerie(folder.path(), words); }

  test::TemporaryFolder folder;
  const fs::path database = folder / "eerie.sqlite", kept = folder / "eerie.sqlite.schema-5";
};

TEST_F(OlderDatabase, IsReadByEveryCommandThatReadsAndStaysAsItIs) {
  const std::string bytes = read_file(database);
  const std::string hash = test::job_directories(database).at(0).filename().string().substr(0, 8);
  const std::vector<std::vector<std::string>> commands = {
      {"status"},
      {"query"},
      {"map", "-o", "map.png"},
      {"show", hash},
      {"log", hash},
      {"check"},
      {"doctor"},
      {"sizes", "-o", "sizes.svg"},
      {"compare", "eerie.sqlite", "eerie.sqlite"}};
  for (const auto& words : commands) {
    const Ended ended = eerie(words);
    EXPECT_EQ(ended.code, 0) << words[0] << ": " << ended.err << ended.out;
  }
  const json row = json::parse(eerie({"query", "--json"}).out).at(0);
  EXPECT_EQ(row.at("scheme"), "closing-gaps");
  EXPECT_EQ(row.at("job_folder"),
            "eerie.sqlite.jobs/" + row.at("hash").get<std::string>().substr(0, 16));
  EXPECT_THAT(eerie({"doctor"}).out, HasSubstr("it has schema 5 of an older eerie"));
  EXPECT_TRUE(read_file(database) == bytes);
  EXPECT_FALSE(fs::exists(kept));
}

TEST_F(OlderDatabase, IsBroughtUpToDateByARunAndADaemonThatKeepWhatItWas) {
  const std::string bytes = read_file(database);
  for (const std::vector<std::string>& words : {std::vector<std::string>{"run", "sweep.json"},
                                                {"daemon", "--until-idle"},
                                                {"doctor", "--fix"}}) {
    const Ended ended = eerie(words);
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_THAT(ended.err, AllOf(HasSubstr("had schema 5 of an older eerie and has schema"),
                                 HasSubstr("it is kept as eerie.sqlite.schema-5")));
    EXPECT_EQ(db::schema_of_file(database), db::latest_version());
    // The copy is a database of its own: the older program may go on with it.
    fs::remove(database);
    fs::rename(kept, database);
    EXPECT_EQ(db::schema_of_file(database), 5);
  }
  EXPECT_EQ(bytes.size(), read_file(database).size());
}

TEST_F(OlderDatabase, IsFollowedByTheDashboardWhileItsOwnProgramWorks) {
  test::Program serve(folder.path(), {"serve", "--port", "0"});
  ASSERT_TRUE(
      test::eventually([&] { return serve.printed().find("http://") != std::string::npos; }));
  serve.send(SIGTERM);
  EXPECT_EQ(serve.wait().code, 0);
  EXPECT_EQ(db::schema_of_file(database), 5);
}

}  // namespace
}  // namespace eerie
