#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>

#include "campaign/job_folder/result_file.hpp"
#include "campaign/job_folder/worker_exit.hpp"
#include "campaign/slurm/slurm_scheduler.hpp"
#include "solver/base/file.hpp"
#include "tests/e2e/impacts.hpp"
#include "tests/e2e/real_slurm.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
namespace fs = std::filesystem;
using namespace std::chrono_literals;

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++count;
  return count;
}

/// Because it was told to, and not only the newest of every 0.1 s.
bool left_a_checkpoint(const manager::Task& task) {
  return fs::exists(task.directory.checkpoint()) &&
         occurrences(read_file(task.directory.log()), "the checkpoint is written") == 1;
}

class OnRealSlurm : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string reason = test::RealSlurm::missing(); !reason.empty())
      GTEST_SKIP() << reason;
    slurm.emplace();
    ASSERT_TRUE(slurm->ready());
    profile.poll_interval_s = 0.2;
    profile.extra_sbatch_options = {"--exclusive"};
  }

  std::unique_ptr<slurm::SlurmScheduler> scheduler() {
    return std::make_unique<slurm::SlurmScheduler>(
        profile, jobs, std::make_shared<slurm::ChildCommands>(), test::program());
  }

  test::TemporaryFolder folder;
  fs::path jobs = folder / "100%a of bob's";  // neither sbatch nor a shell may read it
  std::optional<test::RealSlurm> slurm;
  slurm::SlurmProfile profile;
};

TEST_F(OnRealSlurm, ImpactsSurviveTheDeathOfANodeAndOfTheManagerAndEachEndsOnce) {
  constexpr int count = 48, per_array_task = 4;
  profile.minutes_per_array_task = per_array_task / 60.0;
  const std::vector<manager::Task> tasks = test::impacts(jobs, count, 4000);
  const auto results = [&] {
    return std::ranges::count_if(
        tasks, [](const manager::Task& t) { return fs::exists(t.directory.result()); });
  };

  auto manager = scheduler();
  const std::vector<std::string> names = manager->start(tasks);
  EXPECT_EQ((std::set<std::string>(names.begin(), names.end()).size()), count / per_array_task);
  std::map<std::int64_t, manager::WorkerEnd> ends;
  int requeued = 0;
  const auto work_until = [&](const std::function<bool()>& condition) {
    return test::eventually(
        [&] {
          for (const manager::WorkerEnd& end : manager->wait(50ms)) {
            EXPECT_FALSE(ends.contains(end.job)) << "reported twice";
            ends[end.job] = end;
          }
          requeued += slurm->start_requeued();
          return condition();
        },
        60s);
  };

  ASSERT_TRUE(work_until([&] { return results() >= 6 && !slurm->queue("n2").empty(); }));
  slurm->fail("n2");
  ASSERT_TRUE(work_until([&] { return results() >= 14; }));
  slurm->resume("n2");
  ASSERT_TRUE(work_until([&] { return results() >= 20; }));
  EXPECT_GE(requeued, 1) << "the node had nothing to do when it failed";
  for (const auto& [job, end] : ends) {
    EXPECT_EQ(end.exit_code, 0);
    EXPECT_GT(end.core_seconds.value_or(0), 0);
  }

  // The manager dies, as it might have between sbatch and the note of the id.
  manager.reset();
  for (const auto& entry : fs::directory_iterator(slurm::batches_folder(jobs)))
    fs::remove(entry.path() / "slurm_id");
  manager = scheduler();
  ends.clear();
  ASSERT_TRUE(work_until([&] {
    return std::ranges::none_of(tasks,
                                [&](const manager::Task& task) { return manager->holds(task); });
  }));
  EXPECT_TRUE(ends.empty()) << "the second manager started none";
  EXPECT_EQ(results(), count);
  for (const manager::Task& task : tasks) {
    const std::string hash =
        scene_hash(parse_scene(json::parse(read_file(task.directory.scene()))));
    EXPECT_TRUE(job_folder::read_result(task.directory, hash)) << task.directory.path;
    const std::string log = read_file(task.directory.log());
    EXPECT_EQ(occurrences(log, "done: "), 1u) << log;
  }
  EXPECT_TRUE(fs::is_empty(slurm::batches_folder(jobs)));
}

TEST_F(OnRealSlurm, StoppingCancelsWhatWaitsAndLeavesCheckpointsOfWhatRuns) {
  profile.minutes_per_array_task = 0;
  const std::vector<manager::Task> tasks = test::impacts(jobs, 4, 4e6);
  auto manager = scheduler();
  manager->start(tasks);
  const auto running = [&] {
    return std::ranges::count_if(tasks, [](const manager::Task& t) {
      return test::worker_at_work(t.directory.path).has_value();
    });
  };
  ASSERT_TRUE(test::eventually([&] { return running() == 2; }, 30s));
  std::map<std::int64_t, manager::WorkerEnd> ends;
  const auto ended = [&](std::size_t count) {
    return test::eventually(
        [&] {
          for (const manager::WorkerEnd& end : manager->wait(50ms)) ends[end.job] = end;
          return ends.size() >= count;
        },
        40s);
  };
  manager->stop(tasks, manager::StopKind::with_checkpoint);
  ASSERT_TRUE(ended(4));
  int stopped = 0;
  for (const manager::Task& task : tasks) {
    EXPECT_EQ(ends[task.job].exit_code, job_folder::worker_stopped);
    EXPECT_FALSE(fs::exists(task.directory.result()));
    stopped += left_a_checkpoint(task) ? 1 : 0;
  }
  EXPECT_EQ(stopped, 2);
  EXPECT_TRUE(test::eventually([&] { return slurm->queue().empty(); }, 20s));
}

TEST_F(OnRealSlurm, TheWarningBeforeTheTimeLimitLeavesACheckpoint) {
  // A minute is the least limit. The warning may come earlier than asked for, but hardly before
  // the first step.
  profile.time_limit = 60s;
  profile.signal_before_end_s = 54;
  const std::vector<manager::Task> tasks = test::impacts(jobs, 1, 4e6);
  auto manager = scheduler();
  manager->start(tasks);
  std::vector<manager::WorkerEnd> ends;
  ASSERT_TRUE(test::eventually(
      [&] {
        ends = manager->wait(50ms);
        return !ends.empty();
      },
      50s));
  EXPECT_EQ(ends[0].exit_code, job_folder::worker_stopped);
  EXPECT_FALSE(ends[0].lost);
  EXPECT_FALSE(manager->holds(tasks[0]));
  EXPECT_TRUE(left_a_checkpoint(tasks[0])) << read_file(tasks[0].directory.log());
}

}  // namespace
}  // namespace eerie
