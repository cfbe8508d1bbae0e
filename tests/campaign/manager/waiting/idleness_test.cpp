#include "campaign/manager/waiting/idleness.hpp"

#include <gtest/gtest.h>

namespace eerie::manager {
namespace {

using Moment = Idleness::Moment;

CampaignView view(std::size_t total, std::size_t running, std::size_t done, std::size_t failed) {
  CampaignView v;
  v.total = total, v.running = running, v.done = done, v.failed = failed;
  return v;
}

TEST(Idleness, ComesOnceWhenTheLastJobHasEnded) {
  Idleness idleness;
  EXPECT_EQ(idleness.look(view(2, 2, 0, 0)), std::nullopt);
  EXPECT_EQ(idleness.look(view(2, 1, 1, 0)), std::nullopt);
  EXPECT_EQ(idleness.look(view(2, 0, 2, 0)), Moment::idle);
  EXPECT_EQ(idleness.look(view(2, 0, 2, 0)), std::nullopt);
}

TEST(Idleness, NeedsWorkBeforeIt) {
  Idleness idleness;
  EXPECT_EQ(idleness.look(view(2, 0, 2, 0)), std::nullopt);
  // A job that began and ended between two looks.
  EXPECT_EQ(idleness.look(view(3, 0, 3, 0)), Moment::idle);
}

TEST(Idleness, TellsOfFailuresSinceTheLastTime) {
  Idleness idleness;
  idleness.look(view(1, 1, 0, 0));
  EXPECT_EQ(idleness.look(view(1, 0, 0, 1)), Moment::idle_with_new_failures);
  idleness.look(view(2, 1, 0, 1));
  EXPECT_EQ(idleness.look(view(2, 0, 1, 1)), Moment::idle);
}

TEST(Idleness, IsNoneWhileJobsWaitOrWorkersStop) {
  Idleness idleness;
  idleness.look(view(2, 1, 0, 0));
  EXPECT_EQ(idleness.look(view(2, 0, 1, 0)), std::nullopt);
  CampaignView stopping = view(1, 0, 1, 0);
  stopping.stopping = true;
  EXPECT_EQ(idleness.look(stopping), std::nullopt);
}

}  // namespace
}  // namespace eerie::manager
