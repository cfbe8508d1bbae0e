#include "campaign/manager/waiting/news.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie::manager {
namespace {

TEST(News, TellTheProgramTheEventAndItsFacts) {
  const test::TemporaryFolder folder;
  install_text(folder / "tell.sh",
               "#!/bin/sh\n"
               "echo \"$1 $EERIE_EVENT $EERIE_SWEEP $EERIE_JOBS $EERIE_DONE $EERIE_FAILED "
               "$EERIE_LEFT $EERIE_MESSAGE $EERIE_DATABASE\" > \"${0%/*}/part\"\n"
               "mv \"${0%/*}/part\" \"${0%/*}/news\"\n");
  ::chmod((folder / "tell.sh").c_str(), 0755);
  const News news{.event = "failed", .sweep = "map", .message = "why", .jobs = Tally{9, 6, 1, 2}};
  EXPECT_EQ(tell((folder / "tell.sh").string(), "/data/a.sqlite", news), "");
  ASSERT_TRUE(test::eventually([&] { return std::filesystem::exists(folder / "news"); }));
  EXPECT_EQ(read_file(folder / "news"), "failed failed map 9 6 1 2 why /data/a.sqlite\n");
}

TEST(News, OfAnIdleCampaignCountWhatIsPausedAsLeft) {
  CampaignView view{};
  view.total = 7, view.done = 4, view.failed = 1, view.paused = 2;
  const News idle = news_of(Idleness::Moment::idle, view);
  EXPECT_EQ(idle.event, "idle");
  ASSERT_TRUE(idle.jobs);
  EXPECT_EQ(idle.jobs->total, 7u);
  EXPECT_EQ(idle.jobs->left, 2u);
  EXPECT_EQ(news_of(Idleness::Moment::idle_with_new_failures, view).event, "failed");
}

TEST(News, NeedAProgramThatThereIs) {
  EXPECT_THROW(tell("/nonexistent/program", "a.sqlite", {.event = "idle"}), InputError);
  EXPECT_EQ(tell("", "a.sqlite", {.event = "idle"}), "");
}

}  // namespace
}  // namespace eerie::manager
