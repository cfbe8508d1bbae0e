#include "campaign/manager/request.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <thread>

#include "campaign/manager/inbox.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "db/jobs/control.hpp"
#include "db/jobs/jobs.hpp"
#include "db/store/error.hpp"
#include "db/store/lock.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::manager {
namespace {
using nlohmann::json;
using testing::HasSubstr;
namespace fs = std::filesystem;

Request submission(const std::string& id) {
  const sweeps::Sweep sweep =
      sweeps::parse_sweep({{"name", "two"}, {"grid", {{"v_imp_cm_per_s", {15, 20}}}}}, {}, "test");
  Request request;
  request.id = id;
  request.kind = "submit";
  request.sweep = sweeps::document(sweep);
  request.priority = 3;
  request.wall_limit_s = 7200;
  return request;
}

class Requests : public testing::Test {
 protected:
  std::size_t files_in_inbox(const std::string& extension) {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(path.string() + ".inbox"))
      if (entry.path().extension() == extension) ++count;
    return count;
  }
  void drop(const std::string& name, const std::string& content) {
    fs::create_directories(path.string() + ".inbox");
    std::ofstream(path.string() + ".inbox/" + name) << content;
  }

  test::TemporaryFolder folder;
  fs::path path = folder / "a.sqlite";
  db::Connection connection{path, db::Access::write};
};

TEST_F(Requests, KeepEveryFieldThroughTheirFile) {
  Request r = submission("1");
  r.selection = {"s", {"abcd"}, 0.5, 40, db::Range{15, 20}, db::Range{10, 20}};
  EXPECT_EQ(to_json(parse_request(to_json(r), "test")), to_json(r));
}

TEST_F(Requests, ToSubmitAddJobsWithTheirPriorityAndLimit) {
  EXPECT_EQ(apply(connection, submission("1")),
            (json{{"sweep", "two"}, {"jobs", 2}, {"added", 2}}));
  for (const db::Job& job : db::jobs(connection, {})) {
    EXPECT_EQ(job.priority, 3);
    EXPECT_EQ(job.wall_limit_s, 7200.0);
  }
  EXPECT_EQ(apply(connection, submission("2")).at("added"), 0);
}

TEST_F(Requests, ThatCannotBeUsedAreAnsweredWithTheReason) {
  Request unknown;
  unknown.id = "1";
  unknown.kind = "dance";
  EXPECT_THAT(apply(connection, unknown).at("error").get<std::string>(), HasSubstr("dance"));
  Request torn = submission("2");
  torn.sweep = "{\"name\": ";
  EXPECT_TRUE(apply(connection, torn).contains("error"));
  Request wrong = submission("3");
  wrong.sweep = R"({"name": "x", "grid": {"q": [-1]}})";
  EXPECT_TRUE(apply(connection, wrong).contains("error"));
  EXPECT_EQ(db::jobs(connection, {}).size(), 0u);
}

TEST_F(Requests, InTheInboxAreCarriedOutOnceAndInTheOrderOfTheirTime) {
  const Inbox inbox(path);
  inbox.put(submission("001"));
  Request pause;
  pause.id = "002";
  pause.kind = "pause";
  inbox.put(pause);
  EXPECT_EQ(inbox.take(connection), 2u);
  EXPECT_TRUE(inbox.is_empty());
  EXPECT_EQ(db::count_jobs(connection, std::nullopt).paused, 2u);
  inbox.put(submission("001"));  // as if the manager had been killed before it removed the file
  EXPECT_EQ(inbox.take(connection), 1u);
  EXPECT_EQ(db::answer(connection, "001"), R"({"added":2,"jobs":2,"sweep":"two"})");
}

TEST_F(Requests, ThatAreNoneAreSetAsideAndHarmNothing) {
  drop("1.json", "");
  drop("2.json", "[[[[");
  drop("3.json", R"({"id": "other", "kind": "cancel", "selection": {}})");
  drop("4.json", R"({"id": "4", "kind": "cancel", "selection": {"hashes": 7}})");
  drop("5.json", std::string(100'000, '['));
  drop(".6.json.1.tmp", "half");
  const Inbox inbox(path);
  EXPECT_EQ(inbox.take(connection), 0u);
  EXPECT_EQ(files_in_inbox(".refused"), 5u);
  EXPECT_TRUE(inbox.is_empty());
}

TEST_F(Requests, AreCarriedOutOnTheSpotWhereNobodyWorksOnTheDatabase) {
  const auto answer = send(path, submission("1"), std::chrono::seconds(0));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->at("added"), 2);
}

TEST_F(Requests, GoThroughTheInboxWhereSomebodyWorksOnTheDatabase) {
  const db::Lock lock(path);
  const auto unanswered = send(path, submission("1"), std::chrono::milliseconds(50));
  EXPECT_FALSE(unanswered);
  std::optional<json> answer;
  std::thread client([&] { answer = send(path, submission("2"), std::chrono::seconds(60)); });
  const Inbox inbox(path);
  while (!db::answer(connection, "2")) inbox.take(connection);
  client.join();
  EXPECT_EQ(answer, (json{{"sweep", "two"}, {"jobs", 2}, {"added", 0}}));
  EXPECT_EQ(db::jobs(connection, {}).size(), 2u);
}

}  // namespace
}  // namespace eerie::manager
