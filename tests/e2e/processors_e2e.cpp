// Which cores and threads the program uses.

#include <gmock/gmock.h>
#include <sched.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/disturbed_campaign.hpp"

namespace eerie {
namespace {
using test::Environment;
using testing::HasSubstr;

std::string allowed_cores(const std::string& process) {
  const std::string status = read_file("/proc/" + process + "/status");
  const std::size_t at = status.find("Cpus_allowed:");
  return status.substr(at, status.find('\n', at) - at);
}

TEST(Workers, AreNotBoundToTheFirstCore) {
  const test::TemporaryFolder folder;
  const test::DisturbedCampaign campaign(folder.path(), 2, 60000);
  const Environment bound("OMP_PROC_BIND", "true");
  test::Program daemon(folder.path(), campaign.daemon_words());
  ASSERT_TRUE(test::eventually([&] { return campaign.workers().size() == 2; }));
  for (const pid_t worker : campaign.workers()) {
    EXPECT_EQ(allowed_cores(std::to_string(worker)), allowed_cores("self"));
    EXPECT_THAT(read_file("/proc/" + std::to_string(worker) + "/environ"),
                testing::Not(HasSubstr("OMP_PROC_BIND")));
  }
  EXPECT_THAT(daemon.said(), HasSubstr("OMP_PROC_BIND: not used"));
  daemon.send(SIGTERM);
  daemon.wait();
}

TEST(ASingleRun, HasTheThreadsThatItsEnvironmentAsksFor) {
  const test::TemporaryFolder folder;
  install_text(folder / "scene.json",
               R"({"numerics": {"particles_per_target": 100}, "end": {"time_s": 300}})");
  const auto threads = [&](const char* wanted, const std::string& out) {
    const Environment number("OMP_NUM_THREADS", wanted);
    const test::Ended ended =
        test::eerie(folder.path(), {"solve", "scene.json", "--out", out, "--json"});
    return nlohmann::json::parse(ended.out).at("run").at("threads").get<int>();
  };
  EXPECT_EQ(threads("1", "a"), 1);
  EXPECT_EQ(threads("3", "b"), 3);
}

// A thread that spins for long takes the core of the one that it waits for.
TEST(Threads, SleepSoonWhileTheyWaitUnlessToldOtherwise) {
  const test::TemporaryFolder folder;
  const test::DisturbedCampaign campaign(folder.path(), 1, 60000);
  const auto environment_of_worker = [&] {
    test::Program daemon(folder.path(), campaign.daemon_words());
    EXPECT_TRUE(test::eventually([&] { return campaign.workers().size() == 1; }));
    const std::string all =
        read_file("/proc/" + std::to_string(campaign.workers().at(0)) + "/environ");
    daemon.send(SIGTERM);
    daemon.wait();
    return all;
  };
  EXPECT_THAT(environment_of_worker(), HasSubstr("GOMP_SPINCOUNT="));
  const Environment policy("OMP_WAIT_POLICY", "active");
  EXPECT_THAT(environment_of_worker(), testing::Not(HasSubstr("GOMP_SPINCOUNT=")));
}

}  // namespace
}  // namespace eerie
