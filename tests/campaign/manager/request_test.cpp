#include "campaign/manager/request.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <linux/fs.h>
#include <sys/ioctl.h>
#include <unistd.h>

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
  Request pause{.id = "1", .kind = "pause"};
  pause.selection = {"s", {"abcd"}, 0.5, 40, db::Range{15, 20}, db::Range{10, 20}};
  Request limit{.id = "2", .kind = "wall-limit", .wall_limit_s = 7200};
  Request none{.id = "3", .kind = "wall-limit"};
  Request priority{.id = "4", .kind = "priority", .priority = -3};
  for (const Request& r : {submission("5"), pause, limit, none, priority})
    EXPECT_EQ(to_json(parse_request(to_json(r), "test")), to_json(r));
  EXPECT_EQ(to_json(parse_request(to_json(limit), "test")).at("wall_limit_s"), 7200.0);
  EXPECT_TRUE(to_json(none).at("wall_limit_s").is_null());
  EXPECT_EQ(to_json(none).at("selection"), (json{{"all", true}}));
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

/// What each of these would do is more, or other, than it says.
TEST_F(Requests, ThatSayLessThanTheyShouldDoNothing) {
  apply(connection, submission("0"));
  const char* requests[] = {
      R"("kind": "cancel", "selection": 5)",
      R"("kind": "cancel", "selection": {})",
      R"("kind": "cancel")",
      R"("kind": "cancel", "selection": {"hashes": [""]})",
      R"("kind": "cancel", "selection": {"hashes": []})",
      R"("kind": "cancel", "selection": {"hashes": ["XYZ"]})",
      R"("kind": "cancel", "selection": {"sweeep": "two"})",
      R"("kind": "cancel", "selection": {"all": false})",
      R"("kind": "cancel", "selection": {"all": true, "q": 1})",
      R"("kind": "cancel", "selection": {"q": "1"})",
      R"("kind": "cancel", "selection": {"v_imp_cm_per_s": [1]})",
      R"("kind": "cancel", "selection": {"v_imp_cm_per_s": [90, 1]})",
      R"("kind": "cancel", "selection": {"all": true}, "sweep": "two")",
      R"("kind": "cancel", "selection": {"all": true}, "sometimes": 1)",
      R"("kind": "wall-limit", "selection": {"all": true})",
      R"("kind": "wall-limit", "selection": {"all": true}, "wall_limit_s": -5)",
      R"("kind": "wall-limit", "selection": {"all": true}, "wall_limit_s": 0)",
      R"("kind": "wall-limit", "selection": {"all": true}, "wall_limit_s": 1e300)",
      R"("kind": "wall-limit", "selection": {"all": true}, "wall_limit_s": "2h")",
      R"("kind": "priority", "selection": {"all": true})",
      R"("kind": "priority", "selection": {"all": true}, "priority": 1e20)",
      R"("kind": "priority", "selection": {"all": true}, "priority": 2.5)",
      R"("kind": "priority", "selection": {"all": true}, "priority": 18446744073709551615)",
      R"("kind": "priority", "selection": {"all": true}, "priority": -9223372036854775808)",
      R"("kind": "pause", "selection": {"all": true}, "priority": 1)",
      R"("kind": "submit", "sweep": {"name": "x"})",
      R"("kind": "submit")",
      R"("kind": 7)"};
  int number = 0;
  for (const char* text : requests) {
    const std::string id = std::to_string(++number);
    drop(id + ".json", R"({"id": ")" + id + R"(", )" + text + "}");
  }
  const Inbox inbox(path);
  EXPECT_EQ(inbox.take(connection), 0u);
  EXPECT_EQ(files_in_inbox(".refused"), std::size(requests));
  EXPECT_EQ(files_in_inbox(".reason"), std::size(requests));
  for (const db::Job& job : db::jobs(connection, {})) {
    EXPECT_EQ(job.state, db::JobState::pending);
    EXPECT_EQ(job.wanted, db::Wanted::run);
    EXPECT_EQ(job.priority, 3);
    EXPECT_EQ(job.wall_limit_s, 7200.0);
  }
}

TEST_F(Requests, OfSoManyHashesAsAFileHoldsAreCarriedOut) {
  apply(connection, submission("0"));
  Request cancel{.id = "1", .kind = "cancel"};
  for (int k = 0; k < 5000; ++k) cancel.selection.hashes.push_back(fmt::format("{:08x}", k));
  EXPECT_EQ(apply(connection, cancel), (json{{"jobs", 0}}));
  cancel.id = "2";
  for (const db::Job& job : db::jobs(connection, {}))
    cancel.selection.hashes.push_back(job.hash.substr(0, 10));
  const Inbox inbox(path);
  inbox.put(cancel);
  EXPECT_EQ(inbox.take(connection), 1u);
  EXPECT_EQ(db::answer(connection, "2"), R"({"jobs":2})");
}

TEST_F(Requests, WithASweepOfTooManyLevelsAreSetAsideWithTheReason) {
  std::string sweep = R"({"name": "x", "scene": )";
  for (int k = 0; k < 160'000; ++k) sweep += R"({"a":)";
  sweep += "1" + std::string(160'001, '}');
  drop("1.json", json{{"id", "1"}, {"kind", "submit"}, {"sweep", sweep}}.dump());
  const Inbox inbox(path);
  EXPECT_EQ(inbox.take(connection), 0u);
  EXPECT_TRUE(inbox.is_empty());
  EXPECT_THAT(read_file(path.string() + ".inbox/1.json.refused.reason"), HasSubstr("nested"));
  EXPECT_THAT(db::answer(connection, "1").value_or(""), HasSubstr("nested"));
}

TEST_F(Requests, OfStrangersAreSetAside) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give a file to somebody else";
  apply(connection, submission("0"));
  drop("1.json", R"({"id": "1", "kind": "cancel", "selection": {"all": true}})");
  const std::string file = path.string() + ".inbox/1.json";
  ASSERT_EQ(::chown(file.c_str(), 65534, 65534), 0);
  const Inbox inbox(path);
  EXPECT_EQ(inbox.take(connection), 0u);
  EXPECT_THAT(read_file(file + ".refused.reason"), HasSubstr("user 65534"));
  // A link to what its owner wrote is not its owner's request.
  drop("true.txt", R"({"id": "2", "kind": "cancel", "selection": {"all": true}})");
  fs::create_symlink("true.txt", path.string() + ".inbox/2.json");
  EXPECT_EQ(inbox.take(connection), 0u);
  ASSERT_EQ(::chown(path.c_str(), 65534, 65534), 0);  // now it is the owner's
  drop("3.json", R"({"id": "3", "kind": "pause", "selection": {"all": true}})");
  ASSERT_EQ(::chown((path.string() + ".inbox/3.json").c_str(), 65534, 65534), 0);
  EXPECT_EQ(inbox.take(connection), 1u);
  EXPECT_EQ(db::count_jobs(connection, std::nullopt).paused, 2u);
}

/// Holds a file so that it can be neither removed nor renamed.
class Irremovable {
 public:
  explicit Irremovable(fs::path file) : file_(std::move(file)) { holds_ = set(true); }
  ~Irremovable() { set(false); }
  Irremovable(const Irremovable&) = delete;
  Irremovable& operator=(const Irremovable&) = delete;
  bool holds() const { return holds_; }

 private:
  bool set(bool on) const {
    if (::geteuid() != 0) {
      fs::permissions(file_.parent_path(),
                      on ? fs::perms::owner_read | fs::perms::owner_exec : fs::perms::owner_all);
      return true;
    }
    const int descriptor = ::open(file_.c_str(), O_RDONLY);
    int flags = 0;
    const bool is_set = ::ioctl(descriptor, FS_IOC_GETFLAGS, &flags) == 0 &&
                        (flags = on ? flags | FS_IMMUTABLE_FL : flags & ~FS_IMMUTABLE_FL,
                         ::ioctl(descriptor, FS_IOC_SETFLAGS, &flags) == 0);
    ::close(descriptor);
    return is_set;
  }
  fs::path file_;
  bool holds_ = false;
};

TEST_F(Requests, WhoseFilesCannotBeRemovedAreCarriedOutOnceAndHoldUpNobody) {
  apply(connection, submission("0"));
  drop("1.json", R"({"id": "1", "kind": "pause", "selection": {"all": true}})");
  drop("2.json", "no request");
  const Irremovable first(path.string() + ".inbox/1.json");
  const Irremovable second(path.string() + ".inbox/2.json");
  if (!first.holds()) GTEST_SKIP() << "this file system has no file that stays";
  const Inbox inbox(path);
  EXPECT_EQ(inbox.take(connection), 1u);
  EXPECT_TRUE(inbox.is_empty());
  apply(connection, {.id = "3", .kind = "resume"});
  EXPECT_EQ(Inbox(path).take(connection), 1u);  // a manager that starts anew finds it again
  EXPECT_EQ(db::count_jobs(connection, std::nullopt).paused, 0u);
}

TEST_F(Requests, AreCarriedOutInTheOrderInWhichTheyWerePutWhateverTheClockSays) {
  apply(connection, submission("0"));
  const Inbox inbox(path);
  inbox.put({.id = "2026", .kind = "priority", .priority = 1});
  inbox.put({.id = "1999", .kind = "priority", .priority = 2});  // the clock was set back
  drop("17.json", R"({"id": "17", "kind": "priority", "selection": {"all": true}, "priority": 3})");
  inbox.put({.id = "1998", .kind = "priority", .priority = 4});
  EXPECT_EQ(inbox.take(connection), 4u);
  EXPECT_EQ(db::jobs(connection, {}).at(0).priority, 4);
}

TEST_F(Requests, WaitInTheInboxWhileAnotherProgramWrites) {
  connection.wait_at_most(std::chrono::milliseconds(10));
  const Inbox inbox(path);
  inbox.put(submission("1"));
  db::Connection other(path, db::Access::write);
  other.write([&](auto&) { EXPECT_THROW(inbox.take(connection), db::BusyError); });
  EXPECT_EQ(inbox.take(connection), 1u);
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
