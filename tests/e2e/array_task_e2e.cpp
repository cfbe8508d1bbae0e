#include <gmock/gmock.h>
#include <signal.h>

#include <cstdlib>

#include "campaign/job_folder/worker_exit.hpp"
#include "campaign/job_folder/worker_lock.hpp"
#include "campaign/slurm/batch.hpp"
#include "tests/e2e/impacts.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using test::Ended;
using test::Program;
using testing::HasSubstr;
namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr double short_run_s = 3000, long_run_s = 400'000;

/// What Slurm starts on a node, started by hand.
class AnArrayTask : public testing::Test {
 protected:
  AnArrayTask() {
    ::setenv("SLURM_ARRAY_TASK_ID", "1", 1);
    ::setenv("SLURM_CPUS_PER_TASK", "1", 1);
  }
  ~AnArrayTask() override {
    ::unsetenv("SLURM_ARRAY_TASK_ID");
    ::unsetenv("SLURM_CPUS_PER_TASK");
  }

  void install(const std::vector<manager::Task>& tasks) {
    batch.folder = folder / "batch";
    batch.array.resize(2);  // the first pack is another's
    for (const manager::Task& task : tasks) batch.array[1].push_back({task.job, task.directory});
    slurm::install_batch(batch, test::program());
  }
  std::vector<std::string> words() const { return {"slurm-task", batch.folder.string()}; }
  Ended run() { return test::eerie(folder.path(), words()); }

  test::TemporaryFolder folder;
  slurm::Batch batch;
};

int exit_code(const manager::Task& task) {
  const auto ended = job_folder::read_ended(task.directory);
  return ended ? ended->exit_code : -1;
}
bool has_result(const manager::Task& task) { return fs::exists(task.directory.result()); }

TEST_F(AnArrayTask, RunsItsJobsOneAfterAnotherAndNotesWhatTheyCost) {
  const auto tasks = test::impacts(folder.path(), 2, short_run_s);
  install(tasks);
  const Ended ended = run();
  EXPECT_EQ(ended.code, 0) << ended.err;
  for (const manager::Task& task : tasks) {
    EXPECT_TRUE(has_result(task));
    EXPECT_EQ(exit_code(task), 0);
    EXPECT_GT(job_folder::read_ended(task.directory)->core_seconds, 0);
    EXPECT_GT(job_folder::read_ended(task.directory)->peak_memory_bytes, 0);
  }
}

TEST_F(AnArrayTask, BeforeItsTimeLimitLeavesACheckpointAndStartsNoMore) {
  const auto tasks = test::impacts(folder.path(), 2, long_run_s);
  install(tasks);
  Program program(folder.path(), words());
  ASSERT_TRUE(
      test::eventually([&] { return test::worker_at_work(tasks[0].directory.path).has_value(); }));
  program.send(SIGUSR1);
  EXPECT_EQ(program.wait().code, job_folder::worker_stopped);
  for (const manager::Task& task : tasks) EXPECT_EQ(exit_code(task), job_folder::worker_stopped);
  EXPECT_TRUE(fs::exists(tasks[0].directory.checkpoint()));
  EXPECT_FALSE(fs::exists(tasks[1].directory.log()));
}

TEST_F(AnArrayTask, NotesAWorkerThatWasKilledAndGoesOnWithTheNext) {
  auto tasks = test::impacts(folder.path(), 1, long_run_s);
  tasks.push_back(test::impacts(folder.path(), 1, short_run_s).front());
  tasks[1].job = 1;
  install(tasks);
  Program program(folder.path(), words());
  std::optional<pid_t> worker;
  ASSERT_TRUE(test::eventually(
      [&] { return (worker = test::worker_at_work(tasks[0].directory.path)).has_value(); }));
  ASSERT_EQ(::kill(*worker, SIGKILL), 0);
  EXPECT_EQ(program.wait().code, 0);
  EXPECT_EQ(exit_code(tasks[0]), 128 + SIGKILL);
  EXPECT_TRUE(has_result(tasks[1]));
}

TEST_F(AnArrayTask, LeavesAloneWhatIsDoneTakenBackOrToBeStopped) {
  const auto tasks = test::impacts(folder.path(), 4, short_run_s);
  install(tasks);
  install_text(tasks[0].directory.result(), "{}");
  slurm::install_released(batch, {1});
  install_text(tasks[2].directory.stop(), "");
  EXPECT_EQ(run().code, 0);
  for (int k = 0; k < 3; ++k)
    EXPECT_FALSE(fs::exists(tasks[static_cast<std::size_t>(k)].directory.log())) << k;
  EXPECT_EQ(exit_code(tasks[1]), -1) << "its new batch speaks for it";
  EXPECT_EQ(exit_code(tasks[2]), job_folder::worker_stopped);
  EXPECT_TRUE(has_result(tasks[3]));
}

TEST_F(AnArrayTask, WhoseBatchWasGivenUpDoesNothing) {
  const auto tasks = test::impacts(folder.path(), 1, short_run_s);
  install(tasks);
  slurm::remove_batch(batch);
  const Ended ended = run();
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, HasSubstr("nothing to do"));
  EXPECT_FALSE(fs::exists(tasks[0].directory.log()));
}

TEST_F(AnArrayTask, WaitsForAWorkerOfItsEarlierStart) {
  const auto tasks = test::impacts(folder.path(), 1, short_run_s);
  install(tasks);
  auto other = std::make_unique<job_folder::WorkerLock>(tasks[0].directory);
  Program program(folder.path(), words());
  EXPECT_FALSE(test::eventually([&] { return fs::exists(tasks[0].directory.log()); }, 1s));
  other.reset();
  EXPECT_EQ(program.wait().code, 0);
  EXPECT_TRUE(has_result(tasks[0]));
}

TEST_F(AnArrayTask, StartedOutsideOfSlurmSaysSo) {
  install(test::impacts(folder.path(), 1, short_run_s));
  for (const char* index : {"", "x", "-1", "1.5"}) {
    ::setenv("SLURM_ARRAY_TASK_ID", index, 1);
    const Ended ended = run();
    EXPECT_EQ(ended.code, 2) << index;
    EXPECT_THAT(ended.err, HasSubstr("SLURM_ARRAY_TASK_ID"));
  }
}

}  // namespace
}  // namespace eerie
