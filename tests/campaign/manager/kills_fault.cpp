// The campaign against kill -9, at random instants and at every named point.

#include <gmock/gmock.h>
#include <signal.h>

#include <fstream>
#include <random>
#include <thread>

#include "campaign/manager/inbox.hpp"
#include "solver/base/file.hpp"
#include "solver/base/kill_point.hpp"
#include "tests/support/disturbed_campaign.hpp"

namespace eerie::manager {
namespace {
using test::DisturbedCampaign;
using test::Environment;
using test::Program;
namespace fs = std::filesystem;

/// Starts daemons and kills them or their workers, as the dice fall. Returns the number of kills.
int storm(const DisturbedCampaign& campaign, std::mt19937& dice, int most) {
  int kills = 0;
  while (kills < most && !campaign.everything_is_done()) {
    test::eerie(campaign.folder(), {"retry", "--all"});  // three deaths of one job are no end here
    Program daemon(campaign.folder(), campaign.daemon_words());
    while (kills < most && daemon.running()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20 + dice() % 250));
      const std::vector<pid_t> workers = campaign.workers();
      if (!workers.empty() && dice() % 2 == 0) {
        if (::kill(workers[dice() % workers.size()], SIGKILL) == 0) ++kills;
      } else if (daemon.running()) {
        daemon.send(SIGKILL);
        daemon.wait();
        ++kills;
      }
    }
    if (daemon.running()) daemon.send(SIGKILL), daemon.wait(), ++kills;
  }
  return kills;
}

TEST(Kills, AtRandomInstantsLoseNothingAndDoubleNothing) {
  const int wanted = test::from_environment("EERIE_FAULT_KILLS", 10);
  const int seed = test::from_environment("EERIE_FAULT_SEED", 1);
  std::mt19937 dice(static_cast<unsigned>(seed));
  int kills = 0, rounds = 0;
  for (; kills < wanted && !testing::Test::HasFailure(); ++rounds) {
    const test::TemporaryFolder folder;
    const DisturbedCampaign campaign(folder.path(), 6, 8000);
    kills += storm(campaign, dice, std::min(20, wanted - kills));
    campaign.finish_in_peace();
    campaign.expect_whole();
  }
  std::printf("%d kills in %d rounds of 6 impacts: lost 0, doubled 0\n", kills, rounds);
}

/// Every named point, and those of the files that matter most.
std::vector<std::string> points() {
  std::vector<std::string> all(kill_point_names.begin(), kill_point_names.end());
  for (const char* file :
       {"result.json", "checkpoint.hdf5", "final.hdf5", "scene.json", "ended.json"})
    for (const char* point : {"install.before-rename", "install.before-folder-sync"})
      all.push_back(std::string(point) + "@" + file);
  return all;
}

class KilledAt : public testing::TestWithParam<std::string> {};

TEST_P(KilledAt, APointOfTheWayNothingIsLostOrDoubled) {
  const int passings = test::from_environment("EERIE_FAULT_PASSINGS", 1);
  for (int passing = 1; passing <= passings; ++passing) {
    const test::TemporaryFolder folder;
    const DisturbedCampaign campaign(folder.path(), 2, 1500);
    Request request;
    request.id = new_request_id();
    request.kind = "priority";
    request.priority = 1;
    Inbox(campaign.database()).put(request);
    {
      const Environment armed("EERIE_KILL_AT", GetParam() + ":" + std::to_string(passing));
      Program(campaign.folder(), campaign.daemon_words()).wait();
    }
    campaign.finish_in_peace();
    campaign.expect_whole();
    EXPECT_EQ(campaign.number("SELECT count(*) FROM requests WHERE kind = 'priority'"), 1);
    EXPECT_EQ(campaign.number("SELECT min(priority) FROM jobs"), 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, KilledAt, testing::ValuesIn(points()), [](const auto& point) {
  std::string name = point.param;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
});

/// Every worker of the campaign dies right after a checkpoint, at each of the three attempts that a
/// job has, so that both checkpoints are there; returns a job directory.
fs::path cut_off(const DisturbedCampaign& campaign) {
  const Environment armed("EERIE_KILL_AT", "install.before-folder-sync@checkpoint.hdf5");
  test::eerie(campaign.folder(), campaign.daemon_words());
  return test::job_directories(campaign.database()).at(0);
}

void damage(const fs::path& file, std::mt19937& dice) {
  std::string bytes = read_file(file);
  if (dice() % 2 == 0)
    bytes.resize(dice() % bytes.size());
  else
    bytes[dice() % bytes.size()] ^= static_cast<char>(1 << dice() % 8);
  std::ofstream(file, std::ios::binary) << bytes;
}

TEST(Damage, ToACheckpointIsPassedOver) {
  std::mt19937 dice(7);
  for (int round = 0; round < test::from_environment("EERIE_FAULT_ROUNDS", 2); ++round) {
    const test::TemporaryFolder folder;
    const DisturbedCampaign campaign(folder.path(), 2, 20000);
    const fs::path job = cut_off(campaign);
    ASSERT_FALSE(fs::exists(job / "result.json"));
    damage(job / "checkpoint.hdf5", dice);
    if (round % 2 == 1) damage(job / "checkpoint_previous.hdf5", dice);
    campaign.finish_in_peace();
    campaign.expect_whole();
    EXPECT_THAT(read_file(job / "log.txt"), testing::HasSubstr("passed over"));
  }
}

TEST(Damage, ToAResultThatWasNotCommittedYetMakesItAgain) {
  std::mt19937 dice(8);
  for (int round = 0; round < test::from_environment("EERIE_FAULT_ROUNDS", 2); ++round) {
    const test::TemporaryFolder folder;
    const DisturbedCampaign campaign(folder.path(), 1, 1500);
    {
      const Environment armed("EERIE_KILL_AT", "manager.before-commit");
      test::eerie(folder.path(), campaign.daemon_words());
    }
    const fs::path result = test::job_directories(campaign.database()).at(0) / "result.json";
    ASSERT_TRUE(fs::exists(result));
    damage(result, dice);
    fs::remove(result.parent_path() / "log.txt");  // it ran to its end once, for nothing
    campaign.finish_in_peace();
    campaign.expect_whole();
  }
}

}  // namespace
}  // namespace eerie::manager
