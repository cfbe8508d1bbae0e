#include "campaign/manager/attempts/awake_time.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::manager {
namespace {
using namespace std::chrono_literals;
using nlohmann::json;

class AwakeTimeOf : public testing::Test {
 protected:
  void beat(double awake_s) {
    install_text(directory.heartbeat(), json{{"pid", 1}, {"awake_s", awake_s}}.dump());
  }
  void look_at(std::chrono::seconds second) { awake.look(directory, start + second); }

  test::TemporaryFolder folder;
  job_folder::JobDirectory directory{folder.path()};
  AwakeTime::Clock::time_point start = AwakeTime::Clock::now();
  AwakeTime awake;
};

TEST_F(AwakeTimeOf, AWorkerInAQueueIsNone) {
  look_at(0s);
  look_at(100s);
  EXPECT_EQ(awake.seconds(), 0);
}

TEST_F(AwakeTimeOf, AWorkerIsWhatItSaysAndWhatPassedSince) {
  beat(0);
  look_at(0s);
  for (int s = 1; s <= 4; ++s) look_at(std::chrono::seconds(s));
  EXPECT_DOUBLE_EQ(awake.seconds(), 4);
  beat(5.1);
  look_at(5s);
  EXPECT_DOUBLE_EQ(awake.seconds(), 5.1);
  look_at(7s);
  EXPECT_DOUBLE_EQ(awake.seconds(), 7.1);
}

TEST_F(AwakeTimeOf, AHaltedWorkerStandsStillAfterOneInterval) {
  beat(20);
  look_at(0s);
  for (int s = 1; s <= 3600; ++s) look_at(std::chrono::seconds(s));
  EXPECT_DOUBLE_EQ(awake.seconds(), 25);
  beat(21);
  look_at(3601s);
  EXPECT_DOUBLE_EQ(awake.seconds(), 21);
}

TEST_F(AwakeTimeOf, AWorkerWhoseManagerWasHaltedIsWhatItSays) {
  beat(20);
  look_at(0s);
  look_at(3600s);
  EXPECT_DOUBLE_EQ(awake.seconds(), 25);
  beat(3620);
  look_at(3601s);
  EXPECT_DOUBLE_EQ(awake.seconds(), 3620);
}

/// As workers before this version beat.
TEST_F(AwakeTimeOf, AWorkerThatDoesNotSayIsCountedHere) {
  install_text(directory.heartbeat(), "{}");
  for (int s = 0; s <= 100; ++s) look_at(std::chrono::seconds(s));
  EXPECT_DOUBLE_EQ(awake.seconds(), 100);
}

}  // namespace
}  // namespace eerie::manager
