#include <gmock/gmock.h>
#include <signal.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "campaign/slurm/batch.hpp"
#include "solver/base/file.hpp"
#include "tests/e2e/real_slurm.hpp"
#include "tests/support/disturbed_campaign.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Program;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// The whole program on a cluster: daemon, nodes and files, and nothing of a test's in between.
TEST(DaemonOnSlurm, FinishesEveryJobOnceThoughANodeFailsAndItIsKilled) {
  if (const std::string reason = test::RealSlurm::missing(); !reason.empty())
    GTEST_SKIP() << reason;
  test::RealSlurm slurm;
  ASSERT_TRUE(slurm.ready());
  const test::TemporaryFolder folder;
  install_text(folder / "cluster.json", json{{"poll_interval_s", 1},
                                             {"minutes_per_array_task", 0.002},
                                             {"extra_sbatch_options", json::array({"--exclusive"})}}
                                            .dump());
  constexpr int count = 40;
  constexpr auto patience = std::chrono::seconds(200);  // for a machine that has other work
  const test::DisturbedCampaign campaign(folder.path(), count, 3000);
  const fs::path jobs = folder / "shared";
  std::vector<std::string> words = {"daemon",       "--scheduler", "slurm",       "--profile",
                                    "cluster.json", "--jobs-dir",  jobs.string(), "--until-idle"};
  const auto done = [&] { return campaign.number("SELECT count(*) FROM results"); };
  {
    Program daemon(folder.path(), words);
    ASSERT_TRUE(
        test::eventually([&] { return done() >= 5 && !slurm.queue("n2").empty(); }, patience));
    slurm.fail("n2");
    ASSERT_TRUE(test::eventually([&] { return slurm.start_requeued(), done() >= 12; }, patience));
    daemon.send(SIGKILL);
    daemon.wait();
    slurm.resume("n2");
  }
  // `run` goes on with what the daemon left in the queue: it is the same manager.
  words.pop_back();
  words[0] = "run";
  words.insert(words.begin() + 1, "sweep.json");
  Program run(folder.path(), words);
  EXPECT_TRUE(test::eventually([&] { return slurm.start_requeued(), !run.running(); }, patience));
  const test::Ended ended = run.wait(patience);
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(done(), count);
  EXPECT_EQ(campaign.number("SELECT count(*) FROM jobs WHERE state = 'done'"), count);
  EXPECT_EQ(campaign.number("SELECT count(*) FROM attempts WHERE worker LIKE 'slurm %'"), count);
  int ran_to_their_ends = 0;
  for (const fs::path& job : test::job_directories_in(jobs)) {
    const std::string log = read_file(job / "log.txt");
    const std::size_t first = log.find(" info done: ");
    EXPECT_NE(first, std::string::npos) << log;
    EXPECT_EQ(log.find(" info done: ", first + 1), std::string::npos) << log;
    ++ran_to_their_ends;
  }
  EXPECT_EQ(ran_to_their_ends, count);
  EXPECT_EQ(test::eerie(folder.path(), {"doctor"}).code, 0);
}

TEST(DaemonOnSlurm, FinishesAnExtendedJobWithTheBitsOfTheLongerOne) {
  if (const std::string reason = test::RealSlurm::missing(); !reason.empty())
    GTEST_SKIP() << reason;
  test::RealSlurm slurm;
  ASSERT_TRUE(slurm.ready());
  const test::TemporaryFolder folder;
  install_text(folder / "cluster.json", json{{"poll_interval_s", 1}}.dump());
  const auto run_to = [&](double end_s, const char* database) {
    const json sweep = {
        {"name", "one"},
        {"scene", {{"numerics", {{"particles_per_target", 100}}}, {"end", {{"time_s", end_s}}}}},
        {"grid", {{"numerics.seed", json::array({1})}}}};
    install_text(folder / "one.json", sweep.dump());
    const test::Ended ended =
        test::eerie(folder.path(), {"run", "one.json", "--db", database, "--json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
  };
  run_to(3000, "early.sqlite");
  run_to(5000, "late.sqlite");
  const test::Ended extended = test::eerie(
      folder.path(), {"extend", "--all", "--until", "5000", "--db", "early.sqlite", "--json"});
  ASSERT_EQ(extended.code, 0) << extended.err;
  const std::string hash = json::parse(extended.out).at("extended").at(0).at("as");
  Program daemon(folder.path(), {"daemon", "--db", "early.sqlite", "--scheduler", "slurm",
                                 "--profile", "cluster.json", "--until-idle"});
  EXPECT_EQ(daemon.wait(std::chrono::seconds(200)).code, 0);
  const auto file = [&](const char* database, const char* name) {
    return read_file(folder.path() / (std::string(database) + ".jobs") / hash.substr(0, 16) / name);
  };
  EXPECT_THAT(file("early.sqlite", "log.txt"), HasSubstr("going on from t = "));
  for (const char* name : {"final.hdf5", "history.csv"})
    EXPECT_TRUE(file("early.sqlite", name) == file("late.sqlite", name)) << name << " differs";
}

TEST(DaemonOnSlurm, SaysWhatIsWrongWithAProfile) {
  const test::TemporaryFolder folder;
  install_text(folder / "cluster.json", R"({"partitoin": "batch"})");
  const test::Ended ended =
      test::eerie(folder.path(), {"daemon", "--scheduler", "slurm", "--profile", "cluster.json"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("partitoin"));
  EXPECT_FALSE(fs::exists(folder / "eerie.sqlite"));
}

}  // namespace
}  // namespace eerie
