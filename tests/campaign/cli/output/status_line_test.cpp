#include "campaign/cli/output/status_line.hpp"

#include <gmock/gmock.h>

#include <thread>

namespace eerie::cli {
namespace {

TEST(Eta, SaysNothingBeforeAnythingIsKnown) {
  Eta eta;
  EXPECT_EQ(eta.text(0.5), "") << "a run that goes on from its half has shown no speed yet";
  EXPECT_EQ(eta.text(0.5), "");
  EXPECT_EQ(eta.text(1), "");
}

TEST(Eta, CountsWhatWasDoneSinceItWasAskedFirst) {
  Eta eta;
  eta.text(0.5);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  // A twentieth took a second or more; nine are left.
  EXPECT_THAT(eta.text(0.55), testing::MatchesRegex(" \\| ETA .* s"));
}

}  // namespace
}  // namespace eerie::cli
