#include "campaign/serve/actions.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "campaign/manager/inbox.hpp"
#include "db/jobs/jobs.hpp"
#include "db/store/error.hpp"
#include "db/store/lock.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/db/jobs/sample_jobs.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie::serve {
namespace {
using nlohmann::json;
using testing::HasSubstr;

class Actions : public testing::Test {
 protected:
  Actions() { add_sweep(connection, "all", "{}", test::sample_jobs(3)); }
  std::string refusal_of(const std::string& body) {
    try {
      act(database, body);
    } catch (const InputError& error) {
      return error.what();
    }
    return "taken";
  }
  test::TemporaryFolder folder;
  std::filesystem::path database = folder / "a.sqlite";
  db::Connection connection{database, db::Access::write};
};

TEST_F(Actions, WaitInTheInboxWhereNobodyWorksOnTheDatabase) {
  const Reply reply = act(database, R"({"kind": "pause", "selection": {"sweep": "all"}})");
  EXPECT_EQ(reply.status, 202);
  EXPECT_EQ(db::count_jobs(connection, std::nullopt).paused, 0u)
      << "the database is not written to";
  EXPECT_EQ(manager::Inbox(database).take(connection), 1u);
  EXPECT_EQ(db::count_jobs(connection, std::nullopt).paused, 3u);
}

TEST_F(Actions, GiveTheAnswerOfTheManagerAtWork) {
  const db::Lock lock(database);
  std::jthread manager([&](const std::stop_token& stop) {
    db::Connection own(database, db::Access::write);
    while (!stop.stop_requested()) manager::Inbox(database).take(own);
  });
  const Reply paused = act(database, R"({"kind": "pause", "all": true})");
  EXPECT_EQ(paused.status, 200);
  EXPECT_EQ(json::parse(paused.body), json::parse(R"({"jobs": 3})"));
  EXPECT_EQ(json::parse(act(database, R"({"kind": "resume", "all": true})").body)["jobs"], 3);
}

TEST_F(Actions, RefuseWhatNoManagerWouldTake) {
  EXPECT_THAT(refusal_of("{"), HasSubstr("action"));
  EXPECT_THAT(refusal_of("[]"), HasSubstr("object"));
  EXPECT_THAT(refusal_of(R"({"kind": "drop"})"), HasSubstr("must be one of"));
  EXPECT_THAT(refusal_of(R"({"kind": "cancel"})"), HasSubstr("\"all\": true")) << "not by accident";
  EXPECT_THAT(refusal_of(R"({"kind": "cancel", "selection": {"hashes": ["../../etc"]}})"),
              HasSubstr("digits"));
  EXPECT_THAT(refusal_of(R"({"kind": "cancel", "selection": {"hashes": 7}})"), HasSubstr("action"));
  EXPECT_THAT(refusal_of(R"({"kind": "priority", "all": true})"), HasSubstr("lacks a priority"));
  EXPECT_THAT(
      refusal_of(R"({"kind": "submit", "sweep": "{\"name\": \"x\", \"grid\": {\"speed\": [1]}}"})"),
      HasSubstr("speed"));
  EXPECT_TRUE(manager::Inbox(database).is_empty());
}

TEST_F(Actions, WaitForNoDatabaseThatIsNotThere) {
  const std::filesystem::path none = folder / "none.sqlite";
  EXPECT_THROW(act(none, R"({"kind": "pause", "all": true})"), db::Error);
  EXPECT_FALSE(std::filesystem::exists(none.string() + ".inbox"));
}

TEST_F(Actions, SubmitASweep) {
  const json action = {{"kind", "submit"},
                       {"sweep", R"({"name": "mine", "grid": {"v_imp_cm_per_s": [15, 20]}})"},
                       {"priority", 4}};
  EXPECT_EQ(act(database, action.dump()).status, 202);
  EXPECT_EQ(manager::Inbox(database).take(connection), 1u);
  const auto jobs = db::jobs(connection, {.selection = {.sweep = "mine"}});
  ASSERT_EQ(jobs.size(), 2u);
  EXPECT_EQ(jobs.front().priority, 4);
}

}  // namespace
}  // namespace eerie::serve
