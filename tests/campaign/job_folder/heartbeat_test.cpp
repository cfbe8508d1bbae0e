#include "campaign/job_folder/heartbeat.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie::job_folder {
namespace {

TEST(Heartbeat, SaysWhichProcessLivesAndEndsAtOnceWithItsOwner) {
  const test::TemporaryFolder folder;
  const auto path = folder / "heartbeat.json";
  const auto start = std::chrono::steady_clock::now();
  {
    const Heartbeat heartbeat(path);
    // This thread installs files too while the other one does.
    for (int i = 0; i < 1000 && !std::filesystem::exists(path); ++i)
      install_text(folder / "progress.json", "{}");
  }
  EXPECT_EQ(nlohmann::json::parse(read_file(path)).at("pid"), ::getpid());
  EXPECT_LT(std::chrono::steady_clock::now() - start,
            std::chrono::seconds(4));  // no beat waited for
}

double awake_s(const std::filesystem::path& folder) {
  const auto beat = read_beat({folder});
  return beat && beat->awake_s ? *beat->awake_s : -1;
}

/// Fifty beats of time pass while the process is halted; two more are all that it may count.
TEST(Heartbeat, DoesNotCountTheTimeForWhichItsProcessWasHalted) {
  using namespace std::chrono_literals;
  const test::TemporaryFolder folder;
  const pid_t worker = ::fork();
  if (worker == 0) {
    const Heartbeat heartbeat(folder / "heartbeat.json", 100ms);
    std::this_thread::sleep_for(1h);  // until it is killed
  }
  ASSERT_TRUE(test::eventually([&] { return awake_s(folder.path()) > 0; }));
  ::kill(worker, SIGSTOP);
  std::this_thread::sleep_for(200ms);  // what it was about to write is written
  const double before = awake_s(folder.path());
  std::this_thread::sleep_for(5s);
  ::kill(worker, SIGCONT);
  ASSERT_TRUE(test::eventually([&] { return awake_s(folder.path()) > before; }));
  const double after = awake_s(folder.path());
  ::kill(worker, SIGKILL);
  ::waitpid(worker, nullptr, 0);
  EXPECT_LT(after - before, 4.0);
}

TEST(Heartbeat, ThatCannotBeWrittenDoesNotEndTheRun) {
  const Heartbeat heartbeat("/proc/eerie/heartbeat.json");
}

}  // namespace
}  // namespace eerie::job_folder
