#include "campaign/job_folder/heartbeat.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

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

TEST(Heartbeat, ThatCannotBeWrittenDoesNotEndTheRun) {
  const Heartbeat heartbeat("/proc/eerie/heartbeat.json");
}

}  // namespace
}  // namespace eerie::job_folder
