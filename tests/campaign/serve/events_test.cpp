#include "campaign/serve/events.hpp"

#include <gmock/gmock.h>

#include "db/jobs/jobs.hpp"
#include "tests/db/jobs/sample_jobs.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie::serve {
namespace {
using namespace std::chrono_literals;
using testing::HasSubstr;

class EventsOfADatabase : public testing::Test {
 protected:
  /// Everything that a listener hears until it has heard `word`.
  static std::string heard_until(Events::Listener& listener, const std::string& word) {
    std::string all;
    test::eventually([&] {
      all += listener.next(100ms).value_or("");
      return all.find(word) != std::string::npos;
    });
    return all;
  }
  test::TemporaryFolder folder;
  std::filesystem::path database = folder / "a.sqlite";
  db::Connection connection{database, db::Access::write};
};

TEST_F(EventsOfADatabase, TellOfEveryChange) {
  Events events(database);
  const auto listener = events.listen();
  EXPECT_THAT(heard_until(*listener, "event: work"), HasSubstr("\"worked_on_by\":null"));
  const std::uint64_t before = events.generation();
  add_sweep(connection, "late", "{}", test::sample_jobs(2));
  EXPECT_THAT(heard_until(*listener, "event: database"), HasSubstr("generation"));
  EXPECT_GT(events.generation(), before);
}

TEST_F(EventsOfADatabase, SayNothingButThatTheyLiveWhereNothingChanges) {
  Events events(database);
  const auto listener = events.listen();
  heard_until(*listener, "event: database");
  heard_until(*listener, ": nothing new");
  EXPECT_EQ(listener->next(1500ms), ": nothing new\n\n");
}

TEST_F(EventsOfADatabase, EndForThoseWhoListen) {
  Events events(database);
  const auto listener = events.listen();
  events.end();
  EXPECT_EQ(listener->next(1h), std::nullopt);
}

TEST_F(EventsOfADatabase, HaveRoomForSoManyListenersAtATime) {
  Events events(database);
  std::vector<std::shared_ptr<Events::Listener>> all;
  for (int k = 0; k < Events::most_listeners; ++k) all.push_back(events.listen());
  EXPECT_NE(all.back(), nullptr);
  EXPECT_EQ(events.listen(), nullptr);
  all.pop_back();
  EXPECT_NE(events.listen(), nullptr);
}

TEST_F(EventsOfADatabase, AreThereForThoseWhoAskInsteadOfListening) {
  Events events(database);
  EXPECT_TRUE(test::eventually([&] {
    const auto news = nlohmann::json::parse(events.latest());
    return news.at("database").is_object() && news.at("work").is_object();
  })) << events.latest();
  EXPECT_GT(nlohmann::json::parse(events.latest()).at("again_s"), 0);
}

TEST_F(EventsOfADatabase, LeaveItToTheLastWriterToTidyItsLogAway) {
  const std::filesystem::path other = folder / "other.sqlite";
  auto writer = std::make_unique<db::Connection>(other, db::Access::write);
  Events events(other);
  const auto listener = events.listen();
  const std::uint64_t before = events.generation();
  add_sweep(*writer, "all", "{}", std::vector<db::NewJob>{});
  EXPECT_TRUE(test::eventually([&] { return events.generation() > before; }));
  // Unless it meets the events while they look: then the next last one does.
  EXPECT_TRUE(test::eventually([&] {
    writer.reset();
    if (!std::filesystem::exists(other.string() + "-wal")) return true;
    writer = std::make_unique<db::Connection>(other, db::Access::write);
    return false;
  }));
}

TEST_F(EventsOfADatabase, SurviveADatabaseThatIsNotThere) {
  Events events(folder / "none.sqlite");
  const auto listener = events.listen();
  EXPECT_THAT(heard_until(*listener, "problem"), HasSubstr("none.sqlite"));
}

}  // namespace
}  // namespace eerie::serve
